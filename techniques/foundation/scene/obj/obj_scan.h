// The strict first reading of an OBJ file: every v, vn, vt and f is checked here, with the true line number of what is
// wrong, because tinyobjloader (2.0rc10) turns junk into zeros and passes indices that are out of range on.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "techniques/foundation/math/types.h"
#include "techniques/foundation/scene/load/load.h"

namespace shadowlab::scene {

/// A name in the OBJ file and where it first stands.
struct ObjReference {
    std::string name;
    std::size_t line = 0;
};

struct ObjScan {
    std::vector<dvec3> positions; ///< of the v lines, correctly rounded (tinyobjloader's numbers may be an ulp off)
    std::vector<vec3> normals;    ///< of the vn lines, unit; zero where the file's has no direction
    std::vector<vec2> texcoords;  ///< of the vt lines; not finite where the file's is not
    std::vector<vec3> colors;     ///< linear RGB of the v lines; white where one has none, empty where none has any
    std::vector<std::uint32_t> smoothingGroups; ///< for each face, 0 for none; empty where no face has one
    std::size_t colorsInBytes = 0; ///< line of the first colour above 1, as scanners write them that count to 255; 0: none
    std::vector<ObjReference> libraries;     ///< what mtllib names, each once
    std::vector<ObjReference> usedMaterials; ///< what usemtl names, each once, in order
    /// The checked statements in the form tinyobjloader reads safely: `f` with absolute indices `v`, `v/vt`, `v//vn` or `v/vt/vn`,
    /// `usemtl NAME`, and `mtllib N` where N is an index into `libraries` (so that no blank or backslash splits a
    /// name).
    std::string statements;
    std::size_t unusableNormals = 0; ///< vn without a direction that faces use
    std::size_t unusableNormalLine = 0;
    std::vector<std::string> notes; ///< on statements that change nothing here, one for each kind
};

/// Throws Error "FILE:LINE: ..." at the first fault. A face may stand before the vertices it names by positive index;
/// negative ones count back from the last vertex so far.
ObjScan scanObj(std::string_view text, const std::filesystem::path& file, const Limits& limits);

} // namespace shadowlab::scene
