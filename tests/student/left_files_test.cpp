// What a plug-in's process may leave in the place of a picture.
// SPDX-License-Identifier: MIT
#include "app/student/grading/left_files.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>
#include <string>

#include "app/student/grading/temporary_folder.h"
#include "techniques/foundation/image/png/png.h"

namespace shadowlab::student {
namespace {

namespace fs = std::filesystem;

fs::path written(const fs::path& file, std::size_t bytes) {
    std::ofstream(file, std::ios::binary) << std::string(bytes, 'x');
    return file;
}

TEST(LeftFilesTest, ARegularFileIsReadUpToFourMebibytes) {
    const TemporaryFolder folder;
    const std::size_t most = 4 << 20;
    for (const std::size_t size : {std::size_t{0}, std::size_t{5}, most}) {
        const auto bytes = bytesLeftIn(written(folder.path() / "file", size));
        ASSERT_TRUE(bytes) << size;
        EXPECT_EQ(*bytes, std::vector<std::uint8_t>(size, 'x'));
    }
    EXPECT_FALSE(bytesLeftIn(written(folder.path() / "file", most + 1)));
}

TEST(LeftFilesTest, NothingElseIsRead) {
    const TemporaryFolder folder;
    fs::create_symlink(written(folder.path() / "file", 5), folder.path() / "link");
    ASSERT_EQ(::mkfifo((folder.path() / "pipe").c_str(), 0600), 0);
    for (const fs::path& other : {folder.path() / "none", folder.path() / "link", folder.path() / "pipe", folder.path(), fs::path("/dev/zero")})
        EXPECT_FALSE(bytesLeftIn(other)) << other;
}

TEST(LeftFilesTest, APictureOfAnotherSizeIsNone) {
    const image::Image picture(6, 4, {200, 100, 50, 255});
    std::vector<std::uint8_t> png = image::encodePng(picture);
    EXPECT_EQ(pictureIn(png), picture);
    EXPECT_EQ(pictureIn(png, {6, 4}), picture);
    for (const ivec2 size : {ivec2(4, 6), ivec2(6, 5), ivec2(3, 4), ivec2(0, 0)})
        EXPECT_FALSE(pictureIn(png, size)) << size.x << " x " << size.y;
    png.resize(png.size() / 2);
    EXPECT_FALSE(pictureIn(png)) << "half of a file";
    EXPECT_FALSE(pictureIn({})) << "an empty one";
}

} // namespace
} // namespace shadowlab::student
