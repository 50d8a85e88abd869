// The technique of this folder is in the list, last in its order, that of docs/adding_a_technique.md is, and everything else still is.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>

#include "techniques/registry.h"

namespace shadowlab {
namespace {

TEST(OneMoreTechnique, IsListedBesideTheOthers) {
    const auto all = registeredTechniques();
    ASSERT_GE(all.size(), 4u);
    EXPECT_EQ(all.back().info->id, "inverted");
    EXPECT_EQ(all.back().folder, "inverted");
    for (const char* id : {"unshadowed", "shadow-map", "shadow-volume-zfail", "bounding-spheres"})
        EXPECT_TRUE(std::ranges::any_of(all, [&](const RegisteredTechnique& t) { return t.info->id == id; })) << id;
}

} // namespace
} // namespace shadowlab
