// The lecture's techniques as a group: each refined by a production technique, none among "all", each in one short file.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "app/cli/measure.h"
#include "techniques/registry.h"

namespace shadowlab {
namespace {

std::vector<std::string> idsOf(TechniqueGroup group) {
    std::vector<std::string> ids;
    for (const RegisteredTechnique& technique : techniquesOf(group))
        ids.emplace_back(technique.info->id);
    return ids;
}

TEST(LectureGroupTest, EachHasASisterInProduction) {
    const std::vector<RegisteredTechnique> lecture = techniquesOf(TechniqueGroup::lecture);
    EXPECT_EQ(lecture.size(), 6u);
    for (const RegisteredTechnique& technique : lecture) {
        EXPECT_EQ(technique.folder, "lecture");
        EXPECT_TRUE(technique.info->id.starts_with("lecture-")) << technique.info->id;
        EXPECT_EQ(findTechnique(technique.info->sister).group, TechniqueGroup::production) << technique.info->id;
        EXPECT_FALSE(technique.info->pseudocode.empty()) << "the lecture writes down each of them";
    }
    for (const RegisteredTechnique& technique : techniquesOf(TechniqueGroup::production))
        EXPECT_TRUE(technique.info->sister.empty()) << technique.info->id;
}

// One key leads from each to the other.
TEST(LectureGroupTest, SistersFindEachOther) {
    int pairs = 0;
    for (const RegisteredTechnique& technique : techniquesOf(TechniqueGroup::lecture)) {
        const TechniqueInfo* sister = sisterOf(*technique.info);
        ASSERT_NE(sister, nullptr) << technique.info->id;
        EXPECT_EQ(sister->id, technique.info->sister);
        EXPECT_EQ(sisterOf(*sister), technique.info);
        ++pairs;
    }
    EXPECT_EQ(pairs, 6);
    EXPECT_EQ(sisterOf(findTechnique("shadow-volume"))->id, "lecture-zfail") << "it is counted both ways; its folder's last is z-fail";
    for (const char* map : {"shadow-map-exact", "shadow-map-alias-free"})
        EXPECT_EQ(sisterOf(findTechnique(map))->id, "lecture-shadow-map");
    EXPECT_EQ(sisterOf(findTechnique("unshadowed")), nullptr);
}

TEST(LectureGroupTest, AllMeansTheProductionTechniques) {
    EXPECT_EQ(cli::measuredTechniquesFrom({"lecture"}), idsOf(TechniqueGroup::lecture));
    const std::vector<std::string> all = cli::measuredTechniquesFrom({"all"});
    EXPECT_GE(all.size(), 7u);
    for (const std::string& id : all)
        EXPECT_EQ(findTechnique(id).group, TechniqueGroup::production) << id;
}

// In the list they stand after the production techniques, so that number keys, colours and columns stay those they were.
TEST(LectureGroupTest, TheyStandLastInTheList) {
    std::vector<std::string> expected = idsOf(TechniqueGroup::production), found;
    for (const std::string& id : idsOf(TechniqueGroup::lecture))
        expected.push_back(id);
    for (const RegisteredTechnique& technique : registeredTechniques())
        found.emplace_back(technique.info->id);
    EXPECT_EQ(found, expected);
}

// Who reads an algorithm reads one file, in one sitting.
TEST(LectureGroupTest, NoFileHasMoreThan250Lines) {
    int files = 0;
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(std::filesystem::path(SHADOWLAB_SOURCE_DIR) / "techniques/lecture")) {
        if (!entry.is_regular_file()) continue;
        std::ifstream file(entry.path());
        const auto lines = std::count(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>(), '\n');
        EXPECT_GT(lines, 5) << entry.path();
        EXPECT_LE(lines, 250) << entry.path();
        ++files;
    }
    EXPECT_GE(files, 6);
}

} // namespace
} // namespace shadowlab
