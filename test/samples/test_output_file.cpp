// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include <gtest/gtest.h>

#include <sstream>
#include <stdexcept>

#include "common/images.hpp"
#include "common/output_file.hpp"

namespace {

using namespace files;
using samples::writeImage;
namespace fs = std::filesystem;

class OutputFiles : public testing::Test
{
protected:
    void SetUp() override
    {
        fs::remove_all(folder);
        fs::create_directories(folder);
    }
    void TearDown() override { fs::remove_all(folder); }

    static std::string text(const fs::path& path)
    {
        std::ostringstream out;
        out << std::ifstream(path).rdbuf();
        return out.str();
    }
    long files() const { return std::distance(fs::directory_iterator(folder), fs::directory_iterator()); }

    const fs::path folder = fs::temp_directory_path() /
                            ("gmlpnp_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
    const fs::path file = folder / "out.csv";
};

// The message of what a call throws; empty where it throws nothing.
template <class Call>
std::string complaint(const Call& call)
{
    try {
        call();
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return {};
}

void writeHello(std::ostream& out)
{
    out << "hello\n";
}

TEST_F(OutputFiles, appearWholeAndUnderTheirNameOnly)
{
    OutputFile out(file.string());
    out.stream() << 1.5 << ",";
    EXPECT_FALSE(fs::exists(file));
    out.stream() << 2.5;
    out.commit();
    EXPECT_EQ("1.5,2.5", text(file));
    EXPECT_EQ(1, files());
}

TEST_F(OutputFiles, anErrorLeavesWhatWasThereAndNothingElse)
{
    writeFile(file.string(), writeHello);
    EXPECT_THROW(writeFile(file.string(),
                           [](std::ostream& out) {
                               out << "half";
                               throw std::logic_error("interrupted");
                           }),
                 std::logic_error);
    EXPECT_EQ("hello\n", text(file));
    EXPECT_EQ(1, files());
}

TEST_F(OutputFiles, unwritableFoldersAreNamed)
{
    writeFile(file.string(), writeHello);
    const std::string below = (file / "out.csv").string(), nowhere = (folder / "none" / "out.csv").string();
    for (const std::string& path : {below, nowhere, folder.string()})
        EXPECT_EQ(path + ": cannot be written", complaint([&] { writeFile(path, writeHello); }));
    EXPECT_EQ(below + ".png: cannot be written", complaint([&] { writeImage(below + ".png", cv::Mat1b(4, 4)); }));
    EXPECT_EQ(1, files());
}

TEST_F(OutputFiles, aFullDiskIsAnError)
{
    if (!fs::is_character_file("/dev/full"))
        GTEST_SKIP() << "skipped: no /dev/full here";
    EXPECT_EQ("/dev/full: cannot be written", complaint([] { writeFile("/dev/full", writeHello); }));
    const fs::path picture = folder / "full.png";
    fs::create_symlink("/dev/full", picture);
    EXPECT_EQ(picture.string() + ": cannot be written",
              complaint([&] { writeImage(picture.string(), cv::Mat1b(64, 64)); }));
    EXPECT_TRUE(fs::is_character_file("/dev/full")) << "a device is not replaced by a file";
}

TEST_F(OutputFiles, aLinkStaysALink)
{
    writeFile(file.string(), writeHello);
    const fs::path link = folder / "link.csv";
    fs::create_symlink(file, link);
    writeFile(link.string(), [](std::ostream& out) { out << "through"; });
    EXPECT_TRUE(fs::is_symlink(link));
    EXPECT_EQ("through", text(file));
    EXPECT_EQ(2, files());
}

}  // namespace
