// Shaders: includes, true places in compile errors, and every program there is compiles without a word.
// SPDX-License-Identifier: MIT
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <unistd.h>

#include "techniques/foundation/base/error.h"
#include "techniques/foundation/gl/baseline.h"
#include "techniques/foundation/gl/program.h"
#include "techniques/foundation/gl/read_back.h"
#include "tests/support/gl_fixture.h"

namespace shadowlab {
namespace {

using ShaderSourceTest = testing::GlTest;

/// A folder of shaders that SHADOWLAB_SHADERS points to for the length of a test.
class ShaderFolder {
public:
    ShaderFolder()
        : path_(std::filesystem::temp_directory_path() / ("shadowlab-shaders-" + std::to_string(::getpid()))) {
        std::filesystem::create_directories(path_);
        ::setenv("SHADOWLAB_SHADERS", path_.c_str(), 1);
    }
    ~ShaderFolder() {
        ::unsetenv("SHADOWLAB_SHADERS");
        std::filesystem::remove_all(path_);
    }
    void write(const std::string& name, const std::string& text) const { std::ofstream(path_ / name) << text; }

private:
    std::filesystem::path path_;
};

std::string errorOf(const gl::Program& program) {
    try {
        program.use();
    } catch (const Error& error) {
        EXPECT_EQ(error.status(), ExitStatus::badInput);
        gl::takeDebugMessages(); // the driver says it, too
        return error.what();
    }
    return "compiled";
}

TEST_F(ShaderSourceTest, ErrorsNameTheIncludedFileAndItsLine) {
    const ShaderFolder folder;
    folder.write("part.glsl",
                 "// first line\nfloat half_() { return 0.5; }\nfloat broken() { return undefinedName; }\n");
    folder.write("main.frag",
                 "#version 330 core\n#include \"part.glsl\"\nout vec4 c;\nvoid main() { c = vec4(broken()); }\n");
    EXPECT_TRUE(errorOf({"fullscreen.vert", "main.frag"}).starts_with("part.glsl:3: "))
        << errorOf({"fullscreen.vert", "main.frag"});
}

TEST_F(ShaderSourceTest, ErrorsAfterAnIncludeKeepTheirLine) {
    const ShaderFolder folder;
    folder.write("part.glsl", "\n\n\n\n\nfloat half_() { return 0.5; }\n");
    folder.write("main.frag",
                 "#version 330 core\n#include \"part.glsl\"\nout vec4 c;\nvoid main() { c = vec4(nonsense); }\n");
    EXPECT_TRUE(errorOf({"fullscreen.vert", "main.frag", {"A 1", "B 2"}}).starts_with("main.frag:4: "));
}

TEST_F(ShaderSourceTest, AMissingIncludeIsNamedWithItsPlace) {
    const ShaderFolder folder;
    folder.write("main.frag", "#version 330 core\n\n#include \"materiel.glsl\"\nvoid main() {}\n");
    const std::string message = errorOf({"fullscreen.vert", "main.frag"});
    EXPECT_TRUE(message.starts_with("main.frag:3: ")) << message;
    EXPECT_NE(message.find("material.glsl"), std::string::npos) << message;
}

TEST_F(ShaderSourceTest, ALaterCorrectionIsPickedUp) {
    const ShaderFolder folder;
    folder.write("main.frag", "#version 330 core\nout vec4 c;\nvoid main() { c = vec4(oops); }\n");
    const gl::Program program("fullscreen.vert", "main.frag");
    EXPECT_NE(errorOf(program), "compiled");
    folder.write("main.frag", "#version 330 core\nout vec4 c;\nvoid main() { c = vec4(1.0); }\n");
    EXPECT_EQ(errorOf(program), "compiled");
}

/// What the program paints into a single texel: 0..255.
int paintedRed(const gl::Program& program) {
    const gl::Texture2D texture(GL_RGBA8, {1, 1}, "one texel");
    const gl::Framebuffer framebuffer(&texture, nullptr, "one texel");
    gl::setBaselineState();
    glDisable(GL_DEPTH_TEST);
    framebuffer.bind();
    program.use();
    gl::drawFullscreenTriangle();
    return gl::readRows<glm::u8vec4>(texture, GL_UNSIGNED_BYTE).at(0).r;
}

TEST_F(ShaderSourceTest, AReloadTakesWhatIsRightAndKeepsWhatWasBefore) {
    const ShaderFolder folder;
    const std::string head = "#version 330 core\nout vec4 c;\n";
    folder.write("main.frag", head + "void main() { c = vec4(0.2); }\n");
    const gl::Program program("fullscreen.vert", "main.frag");
    EXPECT_EQ(paintedRed(program), 51);

    folder.write("main.frag", head + "void main() { c = vec4(0.4); }\n");
    EXPECT_EQ(paintedRed(program), 51) << "nobody has asked for a reload yet";
    gl::reloadShaders();
    EXPECT_EQ(paintedRed(program), 102);
    EXPECT_TRUE(gl::takeShaderFaults().empty());

    folder.write("main.frag", head + "\nvoid main() { c = vec4(oops); }\n");
    gl::reloadShaders();
    EXPECT_EQ(paintedRed(program), 102) << "the last good form stays on show";
    gl::takeDebugMessages(); // the driver says it, too
    const std::vector<std::string> faults = gl::takeShaderFaults();
    ASSERT_EQ(faults.size(), 1u);
    EXPECT_TRUE(faults[0].starts_with("main.frag:4: ")) << faults[0];
    EXPECT_EQ(paintedRed(program), 102);
    EXPECT_TRUE(gl::takeShaderFaults().empty()) << "said once for each reload";

    folder.write("main.frag", head + "void main() { c = vec4(0.8); }\n");
    gl::reloadShaders();
    EXPECT_EQ(paintedRed(program), 204);
}

TEST_F(ShaderSourceTest, EveryFileStartsWithWhatItIsFor) {
    ASSERT_GT(gl::embeddedShaders().size(), 20u);
    for (const gl::EmbeddedShader& shader : gl::embeddedShaders()) {
        const bool complete = shader.name.ends_with(".vert") || shader.name.ends_with(".frag");
        EXPECT_EQ(shader.text.starts_with("#version 330 core\n"), complete) << shader.name;
        EXPECT_NE(shader.text.find("// "), std::string_view::npos) << shader.name << " has no comment";
    }
}

} // namespace
} // namespace shadowlab
