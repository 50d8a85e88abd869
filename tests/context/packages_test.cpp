// What is advised names no package that is installed, and none that cannot be had.
// SPDX-License-Identifier: MIT
#include "app/context/packages.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "app/context/backends.h"
#include "techniques/foundation/base/software.h"
#include "tests/foundation/scene/scene_files.h"

namespace shadowlab::context {
namespace {

constexpr const char* kStatus = R"(Package: libegl1
Status: install ok installed
Architecture: amd64

Package: libegl1-mesa-dev
Status: install ok installed

Package: libgl1
Status: deinstall ok config-files

Package: libosmesa6
Status: deinstall ok config-files
Architecture: i386

Package: libosmesa6
Status: install ok installed
Architecture: amd64
)";

class PackagesTest : public ::testing::Test {
protected:
    void SetUp() override {
        std::ofstream(folder.path() / "status") << kStatus;
        ::setenv("DPKG_ADMINDIR", folder.path().c_str(), 1);
    }
    void TearDown() override {
        ::unsetenv("DPKG_ADMINDIR");
        ::unsetenv("LIBGL_DRIVERS_PATH");
    }
    scene::TempFolder folder;
};

TEST_F(PackagesTest, AreInstalledWhereDpkgSaysSo) {
    EXPECT_TRUE(isInstalled("libegl1", folder.path()));
    EXPECT_TRUE(isInstalled("libosmesa6", folder.path())) << "of one architecture";
    EXPECT_FALSE(isInstalled("libgl1", folder.path())) << "removed, though its settings are there";
    EXPECT_FALSE(isInstalled("libegl", folder.path()));
    EXPECT_FALSE(isInstalled("libegl1", folder.path() / "none"));
}

TEST_F(PackagesTest, OnlyMissingOnesAreToBeInstalled) {
    EXPECT_EQ(remedyPackages({"libegl1", "libgl1", "libgl1-mesa-dri"}), "apt install libgl1 libgl1-mesa-dri");
    ::setenv("LIBGL_DRIVERS_PATH", "/none", 1);
    EXPECT_EQ(remedyPackages({"libgl1"}), "apt install libgl1");
    EXPECT_EQ(remedyPackages({"libegl1"}), "unset LIBGL_DRIVERS_PATH");
    ::unsetenv("LIBGL_DRIVERS_PATH");
    EXPECT_TRUE(remedyPackages({"libegl1"}).starts_with("apt reinstall libegl1")) << remedyPackages({"libegl1"});
}

// Also on systems with a package of OSMesa, which is missing here.
TEST_F(PackagesTest, NoFurtherOneHelpsWhereAVariableLeadsEglAstray) {
    folder.write("status", "Package: libegl1\nStatus: install ok installed\n\n"
                           "Package: libgl1-mesa-dri\nStatus: install ok installed\n\n");
    ::setenv("LIBGL_DRIVERS_PATH", "/none", 1);
    EXPECT_EQ(remedyAll(), "unset LIBGL_DRIVERS_PATH");
}

TEST_F(PackagesTest, AreNotInstalledByAptWhereThereIsNoDpkg) {
    ::setenv("DPKG_ADMINDIR", "/none", 1);
    EXPECT_EQ(remedyPackages({"libegl1"}), "install what Debian calls libegl1");
}

TEST(OsmesaPackage, IsThereUntilMesaEndedIt) {
    EXPECT_TRUE(hasOsmesaPackage("NAME=\"Debian GNU/Linux\"\nVERSION_ID=\"12\"\nID=debian\n"));
    EXPECT_TRUE(hasOsmesaPackage("ID=debian\nVERSION_ID=\"13\""));
    EXPECT_FALSE(hasOsmesaPackage("ID=debian\nVERSION_ID=\"14\"\n"));
    EXPECT_FALSE(hasOsmesaPackage("PRETTY_NAME=\"Debian GNU/Linux forky/sid\"\nID=debian\n"))
        << "unstable has no number";
    EXPECT_TRUE(hasOsmesaPackage("ID=ubuntu\nVERSION_ID=\"24.04\"\n"));
    EXPECT_TRUE(hasOsmesaPackage("ID=ubuntu\nVERSION_ID=\"25.04\"\n"));
    EXPECT_FALSE(hasOsmesaPackage("ID=ubuntu\nVERSION_ID=\"25.10\"\n"));
    EXPECT_FALSE(hasOsmesaPackage("ID=fedora\nVERSION_ID=12\n"));
    EXPECT_FALSE(hasOsmesaPackage(""));
}

TEST(Software, IsToldByTheRenderersName) {
    for (const char* name : {"llvmpipe (LLVM 15.0.6, 256 bits)", "softpipe", "Software Rasterizer"})
        EXPECT_TRUE(isSoftware(name)) << name;
    for (const char* name :
         {"", "NVIDIA H100 80GB HBM3/PCIe/SSE2", "Mesa Intel(R) UHD Graphics 620 (KBL GT2)", "virgl (LLVMPIPE)",
          "zink Vulkan 1.3(llvmpipe (LLVM 19.1.7, 256 bits) (MESA_LLVMPIPE))", "D3D12 (Microsoft Basic Render Driver)"})
        EXPECT_FALSE(isSoftware(name)) << name;
}

} // namespace
} // namespace shadowlab::context
