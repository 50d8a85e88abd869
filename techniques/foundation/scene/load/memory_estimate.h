// Estimates the memory of a scene from counts that are known before anything is allocated.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string>

namespace shadowlab::scene {

struct Limits;
struct MemoryBudget;
struct Scene;

// Each a tenth or more above the largest that was measured (peak resident memory, Mesa's software renderer).
constexpr std::uint64_t kBytesAtRest = 160'000'000; ///< program, libraries, driver and a small picture: up to 150 MB
constexpr std::uint64_t kBytesPerTriangle = 450;    ///< shadow volumes 220, ray tracing with its tree 400
constexpr std::uint64_t kBytesPerMeshByte = 10;     ///< text, numbers and corners of an OBJ file while it is read: 9
constexpr std::uint64_t kBytesPerMaterial = 6000;   ///< of MTL files, as tinyobjloader keeps them: 5300
constexpr std::uint64_t kBytesPerTexelRead = 14;    ///< of an image while it is read, beside its file: 13 for a colour image
constexpr std::uint64_t kBytesPerTexel = 9;         ///< of one that has been read, with its texture: 8 for a colour image, 2 for a mask

/// What this process may use: the least of the machine's memory, its control group's and its own limit (`ulimit -v`),
/// less a quarter for everything else. Read once, so that a run has one limit.
std::uint64_t memoryToUse();

/// Bytes that a scene of so many triangles takes in all, beside the pictures that are asked for.
std::uint64_t memoryForTriangles(std::uint64_t triangles, const Limits& limits);
/// Bytes that reading an OBJ file of this size takes in all.
std::uint64_t memoryForMeshFile(std::uint64_t fileBytes, const Limits& limits);
/// Bytes that reading so many materials of MTL files takes in all.
std::uint64_t memoryForMaterials(std::uint64_t materials, const Limits& limits);
/// Bytes that reading an image of so many texels takes in all.
std::uint64_t memoryForImage(std::uint64_t texels, std::uint64_t fileBytes, const Limits& limits);

/// The budget of a loaded scene.
MemoryBudget memoryBudget(const Scene& scene, const Limits& limits);

/// "some 9160 MB of memory are needed, more than the limit of 6000 MB": the middle of a refusal.
std::string beyondMemory(std::uint64_t bytesNeeded, std::uint64_t limit);

} // namespace shadowlab::scene
