#include "state/whole_file.h"

#include <fstream>
#include <random>
#include <stdexcept>
#include <string>
#include <system_error>

#include "checks/text.h"

namespace drench::files {

namespace {

namespace fs = std::filesystem;

// The target of a path: symbolic links are followed, so that they remain links.
fs::path resolved(const fs::path& path) {
    std::error_code problem;
    if (!fs::is_symlink(path, problem)) return path;
    const fs::path target = fs::weakly_canonical(path, problem);
    return problem ? path : target;
}

// The temporary name of a file while it is being written.
fs::path unfinished(const fs::path& path) {
    std::random_device lot;
    return path.parent_path() / textOf("drench-", lot(), "-", lot(), ".part");
}

[[noreturn]] void refuseToWrite(const fs::path& path, const char* why) {
    throw std::runtime_error(textOf("cannot write ", path.string(), ": ", why));
}

}  // namespace

void checkWritable(const fs::path& name) {
    const fs::path path = resolved(name);
    std::error_code problem;
    if (fs::exists(path, problem) && !fs::is_regular_file(path, problem))
        refuseToWrite(path, "it is there, and is not a file; choose another name");
    if (path.has_parent_path()) fs::create_directories(path.parent_path(), problem);
    if (problem) refuseToWrite(path, "its folder cannot be created; choose another");
    const fs::path trial = unfinished(path);
    if (!std::ofstream(trial))
        refuseToWrite(path, "its folder lets nobody write, or not you; choose another");
    fs::remove(trial, problem);
}

void writeWhole(const fs::path& name, std::string_view contents) {
    checkWritable(name);
    const fs::path path = resolved(name);
    const fs::path trial = unfinished(path);
    std::ofstream file(trial, std::ios::binary);
    file.write(contents.data(), static_cast<std::streamsize>(contents.size()));
    file.close();
    std::error_code problem;
    if (file) fs::rename(trial, path, problem);
    if (file && !problem) return;
    fs::remove(trial, problem);
    refuseToWrite(path, "is the disk full, or the name too long?");
}

std::string readWhole(const fs::path& path, std::size_t maxBytes) {
    std::error_code problem;
    if (!fs::exists(path, problem)) throw std::invalid_argument("there is no such file");
    if (!fs::is_regular_file(path, problem)) throw std::invalid_argument("it is no file");
    std::ifstream file(path, std::ios::binary);
    if (!file) throw std::invalid_argument("it cannot be opened");
    const std::uintmax_t size = fs::file_size(path, problem);
    if (problem || size > maxBytes)
        throw std::invalid_argument(textOf("it has more than ", maxBytes >> 20, " MB"));
    std::string contents(static_cast<std::size_t>(size), '\0');
    file.read(contents.data(), static_cast<std::streamsize>(contents.size()));
    if (file.bad()) throw std::invalid_argument("it cannot be read");
    contents.resize(static_cast<std::size_t>(file.gcount()));
    return contents;
}

}  // namespace drench::files
