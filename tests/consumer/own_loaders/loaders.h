// What this application reads with loaders of its own.
#pragma once

#include <array>
#include <string>
#include <vector>

// Positions of the vertices of an OBJ file.
std::vector<std::array<float, 3>> verticesOfObj(const std::string& path);
// Number of morph targets of the first mesh of a glTF binary file.
std::size_t framesOfGlb(const std::string& path);
// Writes a picture, its left half black and its right half white.
void writeHalfWhite(const std::string& path, int side);
// Whether the application's own reader of pictures, which knows JPEG only, reads a file.
bool readsPicture(const std::string& path);
