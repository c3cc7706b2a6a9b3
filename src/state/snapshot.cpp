#include "drench/snapshot.h"

#include <fstream>
#include <stdexcept>
#include <utility>

#include "checks/checks.h"
#include "drench/state.h"
#include "state/checksum.h"
#include "state/snapshot_bytes.h"
#include "state/whole_file.h"

namespace drench {

namespace {

namespace fs = std::filesystem;

// Similar to the signature of PNG: not text, and damaged by any conversion of line ends.
constexpr std::string_view magic =
    "\x89"
    "DRN"
    "CH\r\n";
constexpr std::size_t checksumSize = sizeof(std::uint64_t);
// The size is stored near the start, and is compared with the actual size before further fields are read.
constexpr std::size_t sizeAt = 16, smallest = sizeAt + 8 + checksumSize;

template <typename... Parts>
[[noreturn]] void refuseBytes(const Parts&... why) {
    refuse<std::runtime_error>("this is not a valid snapshot: ", why...);
}

void checkKind(std::string_view bytes) {
    if (bytes.empty()) refuseBytes("it is empty");
    if (bytes.substr(0, magic.size()) != magic.substr(0, bytes.size()))
        refuseBytes(
            "it does not begin as one; it is some other file, or went through a program that changes text");
    if (bytes.size() < smallest) refuseBytes("it ends within its first bytes; it was cut off");
}

void checkFormat(std::uint32_t format) {
    if (format > Snapshot::newestFormat)
        refuseBytes("its format is ", format, ", and this library knows formats up to ",
                    Snapshot::newestFormat, "; use a newer version of Drench");
    if (format == 0) refuseBytes("its format is 0, and formats count from 1; it was damaged");
}

void checkSize(std::uint64_t claimed, std::size_t there) {
    if (claimed == there) return;
    refuseBytes("it should have ", claimed, " bytes and has ", there,
                claimed > there ? "; it was cut off" : "; something was added to it");
}

void checkSum(std::string_view bytes) {
    const std::string_view summed = bytes.substr(0, bytes.size() - checksumSize);
    StateReader sum(bytes.substr(summed.size()));
    if (sum.read<std::uint64_t>() != checksumOf(summed))
        refuseBytes("its checksum does not fit; its bytes have changed since it was made");
}

std::string contentsOf(const fs::path& path) {
    constexpr std::uintmax_t max = std::uintmax_t{1} << 32;
    if (!fs::exists(path)) throw std::runtime_error("it is not there");
    if (!fs::is_regular_file(path)) throw std::runtime_error("it is no file");
    const std::uintmax_t size = fs::file_size(path);
    if (size > max) throw std::runtime_error("it has over 4 GiB, more than any sheet");
    std::ifstream file(path, std::ios::binary);
    if (!file) throw std::runtime_error("it cannot be opened; may you read it?");
    std::string contents(static_cast<std::size_t>(size), '\0');
    file.read(contents.data(), static_cast<std::streamsize>(size));
    if (!file) throw std::runtime_error("reading it fails");
    return contents;
}

}  // namespace

Snapshot::Snapshot(std::string bytes) : bytes_(std::move(bytes)) {
    checkKind(bytes_);
    const std::string_view summed(bytes_.data(), bytes_.size() - checksumSize);
    StateReader reader(summed.substr(magic.size()));
    checkFormat(reader.read<std::uint32_t>());
    const auto precision = reader.read<std::uint32_t>();
    checkSize(reader.read<std::uint64_t>(), bytes_.size());
    checkSum(bytes_);
    if (precision != 4 && precision != 8)
        refuseBytes("its numbers have ", precision, " bytes; there are those of 4 and of 8");
    precision_ = static_cast<int>(precision);
    libraryVersion_ = reader.readText();
    nodes_ = reader.read<std::uint64_t>();
    links_ = reader.read<std::uint64_t>();
    faces_ = reader.read<std::uint64_t>();
    topology_ = reader.read<std::uint64_t>();
    stateBegins_ = summed.size() - reader.left();
}

std::string_view Snapshot::state() const {
    return std::string_view(bytes_).substr(stateBegins_, bytes_.size() - checksumSize - stateBegins_);
}

std::uint64_t Snapshot::hash() const {
    return checksumOf(state());
}

std::string snapshotBytes(const SnapshotHead& head, std::string_view state) {
    StateWriter rest;
    rest.write(std::string_view(DRENCH_VERSION));
    for (const std::uint64_t number : {head.nodes, head.links, head.faces, head.topology}) rest.write(number);
    rest.writeBytes(state);
    StateWriter writer;
    writer.writeBytes(magic);
    writer.write(Snapshot::newestFormat);
    writer.write(static_cast<std::uint32_t>(head.precision));
    writer.write(static_cast<std::uint64_t>(sizeAt + 8 + rest.bytes().size() + checksumSize));
    writer.writeBytes(rest.bytes());
    writer.write(checksumOf(writer.bytes()));
    return writer.bytes();
}

void writeSnapshot(const fs::path& path, const Snapshot& snapshot) {
    files::writeWhole(path, snapshot.bytes());
}

Snapshot readSnapshot(const fs::path& path) {
    try {
        return Snapshot(contentsOf(path));
    } catch (const std::exception& problem) {
        refuse<std::runtime_error>("cannot read ", path.string(), ": ", reasonOf(problem));
    }
}

}  // namespace drench
