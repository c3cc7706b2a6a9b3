#include "drench/state.h"

#include <array>
#include <stdexcept>

#include "checks/checks.h"

namespace drench {

void StateWriter::write(std::string_view text) {
    write(static_cast<std::uint64_t>(text.size()));
    writeBytes(text);
}

void StateWriter::put(std::uint64_t bits, std::size_t size) {
    std::array<char, 8> bytes;
    for (std::size_t i = 0; i < size; ++i)
        bytes[i] = static_cast<char>(static_cast<unsigned char>(bits >> (8 * i)));
    bytes_.append(bytes.data(), size);
}

std::string StateReader::readText() {
    return std::string(readBytes(readCount(1)));
}

std::string_view StateReader::readBytes(std::uint64_t count) {
    if (count > rest_.size())
        refuse<std::runtime_error>("a state ends ", count - rest_.size(), " bytes too early");
    const std::string_view bytes = rest_.substr(0, static_cast<std::size_t>(count));
    rest_.remove_prefix(static_cast<std::size_t>(count));
    return bytes;
}

std::uint64_t StateReader::readCount(std::uint64_t bytesOfEach) {
    const auto count = read<std::uint64_t>();
    if (count > rest_.size() / bytesOfEach)
        refuse<std::runtime_error>("a state claims ", count, " values where ", rest_.size(),
                                   " bytes are left");
    return count;
}

std::uint64_t StateReader::take(std::size_t size) {
    const std::string_view bytes = readBytes(size);
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < size; ++i)
        bits |= static_cast<std::uint64_t>(static_cast<unsigned char>(bytes[i])) << (8 * i);
    return bits;
}

void StateReader::checkFlag(std::uint64_t bits) {
    if (bits > 1) refuse<std::runtime_error>("a state has ", bits, " where yes or no belongs");
}

}  // namespace drench
