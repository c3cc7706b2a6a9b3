// Looks at pictures for the shell tests.
//   picture_probe spread FILE       standard deviation of its brightness, 0 to 255
//   picture_probe differ FILE FILE  mean difference of two pictures of one size, 0 to 255
#include <cmath>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>

#include "viewer/gl/image.h"

namespace {

using drench::viewer::Image;
using drench::viewer::readPng;

double spread(const Image& image) {
    double sum = 0, squares = 0;
    for (const double value : image.rgb) {
        sum += value;
        squares += value * value;
    }
    const double count = double(image.rgb.size());
    return std::sqrt(squares / count - (sum / count) * (sum / count));
}

double difference(const Image& one, const Image& other) {
    if (one.rgb.size() != other.rgb.size()) throw std::runtime_error("the pictures differ in size");
    double sum = 0;
    for (std::size_t i = 0; i < one.rgb.size(); ++i)
        sum += std::abs(double(one.rgb[i]) - double(other.rgb[i]));
    return sum / double(one.rgb.size());
}

}  // namespace

int main(int argc, char** argv) {
    try {
        const std::string what = argc > 1 ? argv[1] : "";
        if (what == "spread" && argc == 3)
            std::printf("%.3f\n", spread(readPng(argv[2])));
        else if (what == "differ" && argc == 4)
            std::printf("%.3f\n", difference(readPng(argv[2]), readPng(argv[3])));
        else
            throw std::runtime_error("say 'spread FILE' or 'differ FILE FILE'");
    } catch (const std::exception& problem) {
        std::fprintf(stderr, "picture_probe: %s\n", problem.what());
        return 2;
    }
}
