#include "measure/table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <sstream>

#include "state/whole_file.h"

namespace drench::demo::table_test {
namespace {

const Table example{{{"step", 0}, {"mass_kg", 3}}, {{0, 1.5}, {1, std::nan("")}}};

std::string contents(const std::filesystem::path& path) {
    std::ifstream file(path);
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

TEST(Table, PrintsAlignedColumnsAndADashForWhatWasNotMeasured) {
    std::ostringstream text;
    print(text, example);
    EXPECT_EQ(text.str(), "step  mass_kg\n   0    1.500\n   1        -\n");
}

TEST(Table, WritesCsvIntoANewFolder) {
    const auto folder = std::filesystem::path(testing::TempDir()) / "drench_table_test";
    std::filesystem::remove_all(folder);
    writeCsv(folder / "a.csv", example);
    EXPECT_EQ(contents(folder / "a.csv"), "step,mass_kg\n0,1.5\n1,\n");
    std::filesystem::remove_all(folder);
}

TEST(Table, NamesTheFileThatItCannotWriteAndLeavesWhatIsThere) {
    const auto folder = std::filesystem::path(testing::TempDir()) / "drench_table_folder";
    std::filesystem::create_directories(folder / "a.csv");
    try {
        writeCsv(folder / "a.csv", example);
        FAIL() << "wrote over a folder";
    } catch (const std::runtime_error& problem) {
        EXPECT_NE(std::string(problem.what()).find("a.csv"), std::string::npos);
    }
    EXPECT_THROW(files::checkWritable("/dev/full"), std::runtime_error);
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
    EXPECT_TRUE(std::filesystem::is_directory(folder / "a.csv"));
    std::filesystem::remove_all(folder);
}

TEST(Table, LeavesFilesBesideItAlone) {
    const auto folder = std::filesystem::path(testing::TempDir()) / "drench_table_beside";
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "a.csv.part") << "precious";
    writeCsv(folder / "a.csv", example);
    EXPECT_EQ(contents(folder / "a.csv.part"), "precious");
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 2);
    std::filesystem::remove_all(folder);
}

TEST(Table, WritesThroughALink) {
    const auto folder = std::filesystem::path(testing::TempDir()) / "drench_table_link";
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder / "elsewhere");
    std::ofstream(folder / "elsewhere" / "b.csv") << "old";
    std::filesystem::create_symlink("elsewhere/b.csv", folder / "a.csv");
    writeCsv(folder / "a.csv", example);
    EXPECT_TRUE(std::filesystem::is_symlink(folder / "a.csv"));
    EXPECT_EQ(contents(folder / "elsewhere" / "b.csv"), "step,mass_kg\n0,1.5\n1,\n");
    std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace drench::demo::table_test
