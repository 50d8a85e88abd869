// Gives equal vertices one index: a hash table over the bits of position, normal, texture coordinate and colour.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "techniques/foundation/base/mixed_bits.h"
#include "techniques/foundation/math/types.h"

namespace shadowlab::scene {

/// All that a mesh holds of a vertex.
struct Vertex {
    vec3 position{0.0f}, normal{0.0f};
    vec2 texcoord{0.0f};
    vec3 color{0.0f};
};

/// Vertices are equal when all their bits are; the caller has turned -0 into +0.
/// Linear probing in a table that is at most half full: about ten times faster here than std::unordered_map.
class VertexWelder {
public:
    /// `expected` is an upper bound on the number of different vertices; the table never grows.
    explicit VertexWelder(std::size_t expected) : slots_(std::bit_ceil(2 * expected + 2), kEmpty) {}

    /// Index of the vertex, counted in the order of first appearance.
    std::uint32_t index(const Vertex& vertex) {
        const Key key = std::bit_cast<Key>(vertex);
        std::size_t slot = hash(key) & (slots_.size() - 1);
        while (slots_[slot] != kEmpty) {
            if (keys_[slots_[slot]] == key) return slots_[slot];
            slot = (slot + 1) & (slots_.size() - 1);
        }
        slots_[slot] = static_cast<std::uint32_t>(keys_.size());
        keys_.push_back(key);
        return slots_[slot];
    }

    /// One of the members of all vertices, in their order: `of(&Vertex::position)`.
    template <typename Member>
    [[nodiscard]] std::vector<Member> of(Member Vertex::* member) const {
        std::vector<Member> values;
        values.reserve(keys_.size());
        for (const Key& key : keys_)
            values.push_back(std::bit_cast<Vertex>(key).*member);
        return values;
    }

private:
    using Key = std::array<std::uint32_t, sizeof(Vertex) / sizeof(std::uint32_t)>;
    static constexpr std::uint32_t kEmpty = 0xffffffffu;

    static std::size_t hash(const Key& key) {
        std::uint64_t h = kGoldenBits; // not 0, which words of 0 would not change
        for (const std::uint32_t word : key)
            h = hashedWith(h, word);
        return static_cast<std::size_t>(h);
    }

    std::vector<std::uint32_t> slots_;
    std::vector<Key> keys_;
};

} // namespace shadowlab::scene
