// What all fuzzers share: numbers from the bytes of an input, and what counts as a refusal.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <limits>
#include <stdexcept>
#include <string>

namespace drench::fuzz {

// Hands out the bytes of an input as numbers; all zeros once they are used up.
class Choices {
  public:
    Choices(const std::uint8_t* bytes, std::size_t count) : bytes_(bytes), left_(count) {}

    bool any() const { return left_ > 0; }
    std::uint8_t byte() { return left_ > 0 ? (--left_, *bytes_++) : std::uint8_t(0); }
    // One of low, low + 1 ... high, at most 256 of them.
    int whole(int low, int high) { return low + byte() % (high - low + 1); }
    bool oneIn(int count) { return whole(1, count) == count; }
    double between(double low, double high) {
        const int first = byte();
        return low + (high - low) * (256 * first + byte()) / 65535;
    }
    // Mostly within the range; now and then at its ends, beyond it, or no number at all.
    double around(double low, double high) {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        switch (whole(0, 23)) {
            case 0:
                return low;
            case 1:
                return high;
            case 2:
                return 2 * low - high;
            case 3:
                return -infinity;
            case 4:
                return std::numeric_limits<double>::quiet_NaN();
            case 5:
                return std::numeric_limits<double>::denorm_min();
            case 6:
                return 1e300;
            default:
                return between(low, high);
        }
    }

  private:
    const std::uint8_t* bytes_;
    std::size_t left_;
};

// Ends the program, which is how a fuzzer learns of a finding.
[[noreturn]] inline void fail(const std::string& what) {
    std::fprintf(stderr, "finding: %s\n", what.c_str());
    std::abort();
}

// Whether a call went well. It may refuse what it is given, as a standard error of Drench's own that says more than the
// name of a function; any other exception is a finding.
template <typename Call>
bool accepts(Call call, const std::string& start = "drench: ") {
    const auto check = [&](const std::exception& problem) {
        if (std::strncmp(problem.what(), start.c_str(), start.size()) != 0 ||
            std::strlen(problem.what()) < start.size() + 10)
            fail(std::string("an exception of another kind: ") + problem.what());
    };
    try {
        call();
        return true;
    } catch (const std::logic_error& problem) {
        check(problem);
    } catch (const std::runtime_error& problem) {
        check(problem);
    } catch (const std::exception& problem) {
        fail(std::string("not refused but broken off: ") + problem.what());
    }
    return false;
}

}  // namespace drench::fuzz

// What a fuzzer consists of; libFuzzer calls it, or replay.cpp.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count);
