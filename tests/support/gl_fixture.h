// A graphics context for the tests of one file: EGL, else OSMesa. No test draws without one; none is skipped for lack
// of it.
// SPDX-License-Identifier: MIT
#pragma once
#include <gtest/gtest.h>

#include <memory>

#include "app/context/context.h"
#include "techniques/foundation/gl/debug.h"
#include "techniques/foundation/gl/handle.h"
#include "tests/support/strict_draws.h"

namespace shadowlab::testing {

class GlTest : public ::testing::Test {
protected:
    static void SetUpTestSuite() { context_ = context::createContext(context::Backend::automatic, true); }
    static void TearDownTestSuite() { context_.reset(); }
    void SetUp() override {
        context_->makeCurrent();
        gl::collectDebugMessages();
        watchDraws();
        objectsBefore_ = gl::liveObjects;
    }
    /// Every test leaves as many GL objects as it found, and no complaint of the driver unheard, nor that of a stricter one.
    void TearDown() override {
        EXPECT_EQ(takeDrawFaults(), "");
        EXPECT_EQ(gl::takeDebugMessages(), "");
        EXPECT_NO_THROW(gl::check("end of test"));
        EXPECT_EQ(gl::liveObjects, objectsBefore_) << "GL objects leaked or freed twice";
    }
    inline static std::unique_ptr<context::Context> context_;
    int objectsBefore_ = 0;
};

} // namespace shadowlab::testing
