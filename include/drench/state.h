// Numbers and texts as bytes, the same on every machine: for what a snapshot holds, and for the state of an
// application's own sources in it.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "drench/export.h"

namespace drench {

/// Writes values one after the other, least byte first: integers and floating-point numbers (IEEE 754) in as many
/// bytes as their type has, so give types of a fixed size; bool as one byte, 0 or 1; a text or a vector as its length
/// in 8 bytes and then its characters or numbers.
class DRENCH_API StateWriter {
  public:
    /// A number of up to 8 bytes, or a bool.
    template <typename Number>
    void write(Number value) {
        static_assert(std::is_arithmetic_v<Number> && sizeof(Number) <= 8, "write numbers of up to 8 bytes");
        std::uint64_t bits = 0;
        if constexpr (std::is_same_v<Number, float>) {
            std::uint32_t half;
            std::memcpy(&half, &value, sizeof half);
            bits = half;
        } else if constexpr (std::is_same_v<Number, double>) {
            std::memcpy(&bits, &value, sizeof bits);
        } else {
            bits = static_cast<std::uint64_t>(value);  // NOLINT(bugprone-signed-char-misuse): put cuts it
        }
        put(bits, sizeof(Number));
    }
    /// Numbers, with how many there are.
    template <typename Number>
    void write(const std::vector<Number>& values) {
        write(static_cast<std::uint64_t>(values.size()));
        for (const Number value : values) write(value);
    }
    /// A text, with its length.
    void write(std::string_view text);
    void write(const std::string& text) { write(std::string_view(text)); }  ///< a text, with its length
    void write(const char* text) { write(std::string_view(text)); }         ///< a text, with its length
    /// As they are, without a length.
    void writeBytes(std::string_view bytes) { bytes_.append(bytes); }

    /// What was written so far.
    const std::string& bytes() const { return bytes_; }

  private:
    void put(std::uint64_t bits, std::size_t size);

    std::string bytes_;
};

/// Reads back what a StateWriter wrote, in the same order and as the same types. All of it throws
/// std::runtime_error that says what is wrong where too few bytes are left, or no writer can have written them, and
/// never takes up more memory than there are bytes.
class DRENCH_API StateReader {
  public:
    /// @param bytes  stay where they are
    explicit StateReader(std::string_view bytes) : rest_(bytes) {}

    /// A number, or a bool.
    template <typename Number>
    Number read() {
        static_assert(std::is_arithmetic_v<Number> && sizeof(Number) <= 8, "read numbers of up to 8 bytes");
        const std::uint64_t bits = take(sizeof(Number));
        if constexpr (std::is_same_v<Number, bool>) {
            checkFlag(bits);
            return bits != 0;
        } else if constexpr (std::is_same_v<Number, float>) {
            const auto half = static_cast<std::uint32_t>(bits);
            float value;
            std::memcpy(&value, &half, sizeof value);
            return value;
        } else if constexpr (std::is_same_v<Number, double>) {
            double value;
            std::memcpy(&value, &bits, sizeof value);
            return value;
        } else {
            return static_cast<Number>(bits);
        }
    }
    /// Numbers that were written as a vector.
    template <typename Number>
    std::vector<Number> readMany() {
        std::vector<Number> values(readCount(sizeof(Number)));
        for (Number& value : values) value = read<Number>();
        return values;
    }
    /// A text.
    std::string readText();
    /// So many bytes as they are.
    std::string_view readBytes(std::uint64_t count);
    /// A number of things of which each takes at least so many bytes.
    std::uint64_t readCount(std::uint64_t bytesOfEach);

    /// Bytes that are left.
    std::size_t left() const { return rest_.size(); }

  private:
    std::uint64_t take(std::size_t size);
    static void checkFlag(std::uint64_t bits);

    std::string_view rest_;
};

}  // namespace drench
