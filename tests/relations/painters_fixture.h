// A graphics context and a painter for every registered technique, kept for all tests of a suite: programs are compiled once.
// SPDX-License-Identifier: MIT
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include "app/context/context.h"
#include "techniques/foundation/gl/debug.h"
#include "techniques/foundation/gl/handle.h"
#include "tests/relations/painter.h"
#include "tests/relations/recipe.h"

namespace shadowlab::relations {

class PaintersTest : public ::testing::Test {
protected:
    using Painters = std::map<std::string, std::unique_ptr<Painter>>;

    static void SetUpTestSuite() {
        context_ = context::createContext(context::Backend::automatic, true);
        context_->makeCurrent();
        objectsBefore_ = gl::liveObjects;
        for (const std::string& id : registeredIds())
            painters_[id] = std::make_unique<Painter>(id);
    }
    static void TearDownTestSuite() {
        painters_.clear();
        EXPECT_EQ(gl::liveObjects, objectsBefore_) << "GL objects leaked or freed twice";
        context_.reset();
    }
    void SetUp() override { gl::collectDebugMessages(); }
    void TearDown() override {
        EXPECT_EQ(gl::takeDebugMessages(), "");
        EXPECT_NO_THROW(gl::check("end of test"));
    }
    static Painters& painters() { return painters_; }

    /// Writes the scenes into a folder of that name, and returns its path.
    static std::string keep(const std::vector<scene::Scene>& scenes, const std::string& name) {
        const std::filesystem::path folder = std::filesystem::temp_directory_path() / "shadowlab-relations" / name;
        for (std::size_t i = 0; i < scenes.size(); ++i)
            writeScene(scenes[i], folder, "scene" + std::to_string(i + 1));
        return folder.string();
    }

private:
    inline static std::unique_ptr<context::Context> context_;
    inline static Painters painters_;
    inline static int objectsBefore_ = 0;
};

} // namespace shadowlab::relations
