// Serialization of numbers and strings, the same on every machine: for snapshots, and for the state of an application's
// own sources in them.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "drench/config.h"

namespace drench {

/// Writes values one after the other, little-endian. Integers and floating-point numbers (IEEE 754) take the size of
/// their type, so use types of fixed size. bool is one byte, 0 or 1. A string or vector is its length in 8 bytes and
/// then its elements.
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
    /// A vector of numbers, with its length.
    template <typename Number>
    void write(const std::vector<Number>& values) {
        write(static_cast<std::uint64_t>(values.size()));
        for (const Number value : values) write(value);
    }
    /// A string, with its length.
    void write(std::string_view text);
    void write(const std::string& text) { write(std::string_view(text)); }  ///< a string, with its length
    void write(const char* text) { write(std::string_view(text)); }         ///< a string, with its length
    /// Bytes as they are, without their length.
    void writeBytes(std::string_view bytes) { bytes_.append(bytes); }

    /// All bytes written so far.
    const std::string& bytes() const { return bytes_; }

  private:
    void put(std::uint64_t bits, std::size_t size);

    std::string bytes_;
};

/// Reads what a StateWriter wrote, in the same order and as the same types. All functions throw std::runtime_error,
/// with the reason, if too few bytes are left or a StateWriter cannot have written them. They never allocate more
/// memory than there are bytes left.
class DRENCH_API StateReader {
  public:
    /// @param bytes  are not copied, and must outlive the reader
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
    /// A vector of numbers.
    template <typename Number>
    std::vector<Number> readMany() {
        std::vector<Number> values(readCount(sizeof(Number)));
        for (Number& value : values) value = read<Number>();
        return values;
    }
    /// A string.
    std::string readText();
    /// `count` bytes as they are.
    std::string_view readBytes(std::uint64_t count);
    /// A number of elements. Throws if that many elements of `bytesOfEach` bytes exceed the bytes left.
    std::uint64_t readCount(std::uint64_t bytesOfEach);

    /// Number of bytes left.
    std::size_t left() const { return rest_.size(); }

  private:
    std::uint64_t take(std::size_t size);
    static void checkFlag(std::uint64_t bits);

    std::string_view rest_;
};

}  // namespace drench
