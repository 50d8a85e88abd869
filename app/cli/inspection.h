// What `inspect` finds out about a mesh file or a scene, as plain values. Needs no OpenGL.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/coinciding.h"
#include "techniques/foundation/math/types.h"
#include "techniques/foundation/scene/load/load.h"
#include "techniques/foundation/scene/model/scene.h"
#include "techniques/foundation/scene/query/topology/mesh_topology.h"

namespace shadowlab::cli {

/// Is a mesh, as it stands in the world, of a size that metres are made for?
enum class Scale { ordinary, tiny, huge };
constexpr double kTinyMetres = 1e-3, kHugeMetres = 1e4; ///< largest extent

/// One count of a mesh, as it is called: in JSON, as a line, as a column, and what it is.
struct MeshCount {
    const char *key, *line, *column, *meaning;
    std::uint64_t scene::MeshReport::*value;
};

inline constexpr std::array kMeshCounts{
    MeshCount{"triangles", "triangles", "triangles", "", &scene::MeshReport::triangles},
    MeshCount{"degenerateTriangles", "  degenerate", "degenerate", "without area, left out when the file was read",
          &scene::MeshReport::droppedTriangles},
    MeshCount{"duplicateTriangles", "  duplicate", "duplicate", "with the same three corners as an earlier one",
          &scene::MeshReport::duplicateTriangles},
    MeshCount{"vertices", "vertices", "vertices", "in the buffers: one for each position, normal and texture coordinate",
          &scene::MeshReport::vertices},
    MeshCount{"weldedVertices", "  welded", "welded", "positions that differ", &scene::MeshReport::weldedVertices},
    MeshCount{"edges", "edges", "edges", "between welded vertices", &scene::MeshReport::edges},
    MeshCount{"boundaryEdges", "  boundary", "boundary", "of one face: the mesh is open there",
          &scene::MeshReport::boundaryEdges},
    MeshCount{"multipleEdges", "  multiple", "multiple", "of more than two faces", &scene::MeshReport::multipleEdges},
    MeshCount{"inconsistentEdges", "  inconsistent", "inconsistent", "of two faces with opposite windings",
          &scene::MeshReport::inconsistentEdges},
    MeshCount{"components", "components", "components", "pieces that hang together by edges",
          &scene::MeshReport::components}};

struct InspectedMesh {
    std::string name;                 ///< the file's, or of the first object that shows it
    std::vector<std::string> objects; ///< those that show it, by name
    std::vector<std::shared_ptr<const scene::Mesh>> pieces; ///< one, or several, each about an origin of its own (obj/mesh_pieces.h)
    scene::MeshReport report;      ///< of all pieces
    bool outward = false;          ///< as scene/query/topology/outward_parts.h has it
    dvec3 sizeMetres{0.0};         ///< extent along x, y and z, as the file has it
    dvec3 sizeWithoutOutliers{0.0}; ///< the same without vertices that lie far from most others
    double stepMetres = 0.0;       ///< largest distance between neighbouring floats, outliers left out
    double shortestEdge = 0.0;     ///< one edge in a hundred is shorter; in metres
    double largestInWorld = 0.0;   ///< largest extent without outliers, in metres, of the largest object that shows it
    Scale scale = Scale::ordinary; ///< of that extent
};

/// One sentence that a technique has for some of the meshes.
struct Remark {
    std::string technique, sentence;
    std::vector<std::size_t> meshes;
};

/// What a material is made of, and which images lie on it.
struct MaterialLook {
    scene::Material material;
    bool vertexColors = false; ///< a mesh that it belongs to has colours at its vertices
};

struct SceneContent {
    std::size_t objects = 0;                  ///< surfaces of lights are not counted
    std::map<std::string, int> lights;        ///< how many of each type
    std::size_t cameras = 1;                  ///< views included
    std::vector<std::string> views;           ///< names of cameras to choose from, by --view
    std::size_t nodes = 0, images = 0;        ///< of a glTF file
    std::vector<std::string> castNoShadow;    ///< names of objects
    std::vector<std::string> receiveNoShadow; ///< names of objects
};

/// A material that shines, and from which sides of a surface.
struct InspectedEmitter {
    std::string material;
    scene::EmittingSides emits;
};

struct Inspection {
    std::string file, name;
    std::string kind = "scene";        ///< or "mesh" (OBJ), or "gltf"
    std::optional<SceneContent> scene; ///< none for a bare mesh
    std::uint64_t triangles = 0;       ///< of all objects, repetitions included
    std::vector<MaterialLook> materials; ///< in the order of the file
    std::vector<std::string> notes;
    std::vector<InspectedEmitter> emitters; ///< without those of lights
    std::vector<InspectedMesh> meshes;      ///< each once, in the order in which objects show them
    std::vector<Coinciding> coinciding;     ///< faces at one place
    std::vector<Remark> remarks;            ///< in the order of the techniques
};

/// `file`: an .obj, a .gltf or .glb, a .json or the name of a built-in scene. Throws Error (badInput, overLimit) for what cannot be loaded.
Inspection inspectFile(const std::string& file, const scene::LoadOptions& loading);

} // namespace shadowlab::cli
