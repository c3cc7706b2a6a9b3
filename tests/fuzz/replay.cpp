// Runs a fuzzer without libFuzzer: each input of a corpus once as it is, and a number of changed ones, always the same.
//   PROGRAM CORPUS COUNT [LAST]    the input under way stands in the file LAST, for when it ends the program
#include <algorithm>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <random>
#include <vector>

#include "choices.h"

namespace {

using Input = std::vector<char>;

std::vector<Input> readCorpus(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    std::vector<Input> inputs;
    for (const auto& path : files) {
        std::ifstream file(path, std::ios::binary);
        inputs.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
    }
    return inputs;
}

Input changed(Input input, std::mt19937& random) {
    if (input.empty()) input.push_back(0);
    for (auto changes = 1 + random() % 8; changes > 0; --changes) {
        const std::size_t position = random() % input.size();
        input[position] = static_cast<char>(random());
    }
    if (random() % 4 == 0) input.resize(1 + random() % input.size());
    return input;
}

void run(const Input& input, const char* last) {
    if (last)
        std::ofstream(last, std::ios::binary).write(input.data(), static_cast<std::streamsize>(input.size()));
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(input.data()), input.size());
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc != 3 && argc != 4) throw std::runtime_error("give a folder and a number");
    const char* const last = argc == 4 ? argv[3] : nullptr;
    const std::vector<Input> inputs = readCorpus(argv[1]);
    if (inputs.empty()) throw std::runtime_error("the corpus is empty");
    for (const Input& input : inputs) run(input, last);
    std::mt19937 random(1);
    for (int left = std::stoi(argv[2]); left > 0; --left) {
        const Input& input = inputs[random() % inputs.size()];
        run(changed(input, random), last);
    }
} catch (const std::exception& problem) {
    std::cerr << "replay: " << problem.what() << '\n';
    return 2;
}
