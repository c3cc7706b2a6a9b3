#include "drench/files/frame_files.h"

#include <cmath>
#include <iomanip>
#include <sstream>

#include "checks/checks.h"
#include "state/whole_file.h"

namespace drench {

namespace {

void check(const std::vector<ClothFrame>& sheets) {
    if (sheets.empty()) refuse("there are no sheets to write; give at least one");
    for (const ClothFrame& sheet : sheets) validate(sheet);
}

// Enough digits for an exact single-precision value, with a decimal point in every locale.
std::ostringstream plainText() {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text << std::setprecision(9);
    return text;
}

void writeVectors(std::ostream& text, const char* kind, const std::vector<Eigen::Vector3f>& vectors) {
    for (const Eigen::Vector3f& v : vectors)
        text << kind << ' ' << v.x() << ' ' << v.y() << ' ' << v.z() << '\n';
}

}  // namespace

void writeObj(const std::filesystem::path& path, const std::vector<ClothFrame>& sheets) {
    check(sheets);
    std::ostringstream text = plainText();
    text << "# Drench; metres, y is up\n";
    std::size_t before = 1;  // vertices are numbered throughout the file, from 1
    for (const ClothFrame& sheet : sheets) {
        text << "o " << sheet.name << '\n';
        writeVectors(text, "v", sheet.positions);
        writeVectors(text, "vn", sheet.normals);
        for (const auto& triangle : sheet.triangles) {
            text << 'f';
            for (const int node : triangle) {
                const std::size_t number = before + static_cast<std::size_t>(node);
                text << ' ' << number << "//" << number;
            }
            text << '\n';
        }
        before += sheet.positions.size();
    }
    files::writeWhole(path, text.str());
}

void writeCsv(const std::filesystem::path& path, double time, const std::vector<ClothFrame>& sheets) {
    check(sheets);
    if (!std::isfinite(time)) refuse("the time of a CSV file is ", time, "; give seconds");
    std::ostringstream text = plainText();
    text << "time_s,sheet,node,x_m,y_m,z_m,mass_kg,pore_kg,film_kg,film_m,content_kg_per_kg,saturation,red,"
            "green,blue\n";
    for (const ClothFrame& sheet : sheets)
        for (std::size_t n = 0; n < sheet.positions.size(); ++n) {
            const Eigen::Vector3f &position = sheet.positions[n], &colour = sheet.colours[n];
            text << time << ',' << sheet.name << ',' << n << ',' << position.x() << ',' << position.y() << ','
                 << position.z() << ',' << sheet.masses[n] << ',' << sheet.poreMasses[n] << ','
                 << sheet.filmMasses[n] << ',' << sheet.filmThicknesses[n] << ',' << sheet.moistureContents[n]
                 << ',' << sheet.saturations[n] << ',' << colour.x() << ',' << colour.y() << ',' << colour.z()
                 << '\n';
        }
    files::writeWhole(path, text.str());
}

std::filesystem::path numbered(const std::filesystem::path& path, int number) {
    if (number < 0) refuse("a file of a sequence has the number ", number, "; give 0 or more");
    std::ostringstream name = plainText();
    name << path.stem().string() << '.' << std::setw(4) << std::setfill('0') << number
         << path.extension().string();
    std::filesystem::path one = path;
    one.replace_filename(name.str());
    return one;
}

}  // namespace drench
