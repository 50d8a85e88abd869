// SPDX-License-Identifier: MIT
#include "techniques/radiosity/interpolation/patch_borders.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "techniques/radiosity/patches/contacts.h"

namespace shadowlab::radiosity {

namespace {

const double kCreaseCosine = std::cos(glm::radians(50.0)); // see patchBorders() in the header

/// For every object: the contact tolerance, and the mean edge length of its patches, in metres.
struct Scales {
    std::vector<double> touching, edge;
};

Scales scalesOf(const Faces& faces, const std::vector<Patch>& patches) {
    std::vector<trace::CentredBox> boxes;
    std::vector<double> lengths, edges;
    for (const Patch& patch : patches) {
        const std::uint32_t object = faces.all[patch.face].object;
        if (object >= boxes.size()) {
            boxes.resize(object + 1);
            lengths.resize(object + 1);
            edges.resize(object + 1);
        }
        const Polygon& polygon = patch.polygon;
        for (std::size_t i = 0; i < polygon.count(); ++i) {
            boxes[object].include(polygon[i]);
            lengths[object] += glm::distance(polygon[i], polygon[(i + 1) % polygon.count()]);
            ++edges[object];
        }
    }
    Scales scales;
    for (std::size_t object = 0; object < boxes.size(); ++object) {
        const bool isEmpty = edges[object] == 0;
        scales.touching.push_back(isEmpty ? 1 : kTouching * glm::distance(boxes[object].lower, boxes[object].upper));
        scales.edge.push_back(isEmpty ? 1 : lengths[object] / edges[object]);
    }
    return scales;
}

/// A grid of boxes for each object: finds the points near a position.
class PointGrid {
public:
    /// `widths`: the side of a box for every object, metres.
    explicit PointGrid(std::vector<double> widths) : widths_(std::move(widths)) {}

    void add(std::uint32_t object, const dvec3& positionCentred, std::uint32_t number) {
        const auto place = placeOf(object, positionCentred);
        boxes_[{object, place[0], place[1], place[2]}].push_back(number);
    }

    /// Calls visit(number) for all points of that object in `box`, and possibly for some outside.
    template <typename Visit>
    void near(std::uint32_t object, const trace::CentredBox& box, const Visit& visit) const {
        const auto lower = placeOf(object, box.lower), upper = placeOf(object, box.upper);
        for (std::int64_t x = lower[0]; x <= upper[0]; ++x)
            for (std::int64_t y = lower[1]; y <= upper[1]; ++y)
                for (std::int64_t z = lower[2]; z <= upper[2]; ++z)
                    if (const auto found = boxes_.find({object, x, y, z}); found != boxes_.end())
                        for (const std::uint32_t number : found->second)
                            visit(number);
    }

private:
    [[nodiscard]] std::array<std::int64_t, 3> placeOf(std::uint32_t object, const dvec3& positionCentred) const {
        const dvec3 place = glm::floor(positionCentred / widths_[object]);
        return {static_cast<std::int64_t>(place.x), static_cast<std::int64_t>(place.y),
                static_cast<std::int64_t>(place.z)};
    }

    std::vector<double> widths_;
    std::map<std::array<std::int64_t, 4>, std::vector<std::uint32_t>> boxes_;
};

/// Corners of patches, and ends of contacts; points in the same place are one.
class Points {
public:
    explicit Points(const Scales& scales)
        // For the search along edges, boxes of an edge's length; for the search of equal points, of some tolerances.
        : scales_(scales), places_(timesEight(scales.touching)), alongEdges_(scales.edge) {}

    std::uint32_t at(std::uint32_t object, const dvec3& positionCentred) {
        const double touching = scales_.touching[object];
        std::uint32_t found = PatchBorders::kNone;
        places_.near(object, boxAbout(positionCentred, touching), [&](std::uint32_t number) {
            if (number < found && glm::distance(all[number], positionCentred) <= touching) found = number;
        });
        if (found != PatchBorders::kNone) return found;
        found = static_cast<std::uint32_t>(all.size());
        all.push_back(positionCentred);
        places_.add(object, positionCentred, found);
        alongEdges_.add(object, positionCentred, found);
        return found;
    }

    /// The points inside the edge, in their order along it, without its ends.
    [[nodiscard]] std::vector<std::uint32_t> within(std::uint32_t object, std::uint32_t from, std::uint32_t to) const {
        const double touching = scales_.touching[object];
        const dvec3 way = all[to] - all[from];
        const double length = glm::length(way);
        std::vector<std::pair<double, std::uint32_t>> found;
        const auto steps = static_cast<int>(std::ceil(length / scales_.edge[object]));
        for (int step = 0; step < steps; ++step) {
            trace::CentredBox box;
            box.include(all[from] + static_cast<double>(step) / steps * way);
            box.include(all[from] + static_cast<double>(step + 1) / steps * way);
            box.grow(touching);
            alongEdges_.near(object, box, [&](std::uint32_t number) {
                if (number == from || number == to) return;
                const double along = glm::dot(all[number] - all[from], way) / (length * length);
                if (along > 0 && along < 1 && glm::distance(all[number], all[from] + along * way) <= touching)
                    found.emplace_back(along, number);
            });
        }
        std::ranges::sort(found);
        std::vector<std::uint32_t> numbers;
        for (const auto& [along, number] : found) // two boxes may hold the same point
            if (numbers.empty() || numbers.back() != number) numbers.push_back(number);
        return numbers;
    }

    std::vector<dvec3> all;

private:
    static std::vector<double> timesEight(std::vector<double> widths) {
        for (double& width : widths)
            width *= 8;
        return widths;
    }
    static trace::CentredBox boxAbout(const dvec3& positionCentred, double metres) {
        trace::CentredBox box;
        box.include(positionCentred);
        box.grow(metres);
        return box;
    }
    const Scales& scales_;
    PointGrid places_, alongEdges_;
};

/// Is there a contact with a third face at that point, which lies on an edge of both patches?
bool isContact(const Faces& faces, const std::vector<std::vector<Contact>>& contacts, std::uint32_t faceA,
               std::uint32_t faceB, const dvec3& placeCentred, double touching) {
    const auto isSame = [&](std::uint32_t a, std::uint32_t b) { // or the other side of the same sheet
        return faces.all[a].triangles[0] == faces.all[b].triangles[0];
    };
    const auto covers = [&](const Contact& contact) {
        const dvec3 way = contact.to - contact.from;
        const double along = std::clamp(glm::dot(placeCentred - contact.from, way) / glm::dot(way, way), 0.0, 1.0);
        return !isSame(contact.other, faceA) && !isSame(contact.other, faceB) &&
               // each of the two may be off by the tolerance
               glm::distance(placeCentred, contact.from + along * way) <= 2 * touching;
    };
    return std::ranges::any_of(contacts[faceA], covers) ||
           (faceB != faceA && std::ranges::any_of(contacts[faceB], covers));
}

/// The borders with all their points, not linked to neighbours yet.
PatchBorders unlinkedBorders(const Faces& faces, const std::vector<Patch>& patches,
                             const std::vector<std::vector<Contact>>& contacts, const Scales& scales) {
    Points points(scales);
    std::vector<std::vector<std::uint32_t>> corners(patches.size());
    for (std::size_t i = 0; i < patches.size(); ++i)
        for (const dvec3& corner : patches[i].polygon.corners())
            corners[i].push_back(points.at(faces.all[patches[i].face].object, corner));
    for (std::size_t face = 0; face < contacts.size(); ++face)
        for (const Contact& contact : contacts[face]) // where a wall ends, the surfaces on its two sides meet
            for (const dvec3& end : {contact.from, contact.to})
                if (faces.all[face].object < scales.edge.size()) points.at(faces.all[face].object, end);

    PatchBorders borders;
    for (std::size_t i = 0; i < patches.size(); ++i) {
        std::vector<std::uint32_t> border;
        for (std::size_t k = 0; k < corners[i].size(); ++k) {
            border.push_back(corners[i][k]);
            const auto within = points.within(faces.all[patches[i].face].object, corners[i][k],
                                              corners[i][(k + 1) % corners[i].size()]);
            border.insert(border.end(), within.begin(), within.end());
        }
        const auto repeated = std::ranges::unique(border); // of edges shorter than the tolerance
        border.erase(repeated.begin(), repeated.end());
        if (border.size() > 1 && border.back() == border.front()) border.pop_back();
        borders.first.push_back(static_cast<std::uint32_t>(borders.pieces.size()));
        for (const std::uint32_t point : border)
            borders.pieces.push_back({point, static_cast<std::uint32_t>(i)});
    }
    borders.first.push_back(static_cast<std::uint32_t>(borders.pieces.size()));
    borders.pointsCentred = std::move(points.all);
    return borders;
}

} // namespace

std::vector<std::uint32_t> PatchBorders::neighbours(std::size_t patch) const {
    std::vector<std::uint32_t> numbers;
    for (const Piece& piece : of(patch))
        if (piece.across != PatchBorders::kNone) numbers.push_back(pieces[piece.across].patch);
    std::ranges::sort(numbers);
    const auto repeated = std::ranges::unique(numbers);
    numbers.erase(repeated.begin(), repeated.end());
    return numbers;
}

PatchBorders patchBorders(const Faces& faces, const std::vector<Patch>& patches) {
    const std::vector<std::vector<Contact>> contacts = contactsOf(faces);
    const Scales scales = scalesOf(faces, patches);
    PatchBorders borders = unlinkedBorders(faces, patches, contacts, scales);
    const auto endOf = [&](std::uint32_t piece) { return borders.pieces[borders.after(piece)].point; };
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>> piecesFromTo;
    for (std::uint32_t piece = 0; piece < borders.pieces.size(); ++piece)
        piecesFromTo[{borders.pieces[piece].point, endOf(piece)}].push_back(piece);
    for (std::uint32_t piece = 0; piece < borders.pieces.size(); ++piece) {
        PatchBorders::Piece& here = borders.pieces[piece];
        const auto others = piecesFromTo.find({endOf(piece), here.point});
        if (here.across != PatchBorders::kNone || others == piecesFromTo.end()) continue;
        const Patch& patch = patches[here.patch];
        const Face& face = faces.all[patch.face];
        double flattest = kCreaseCosine;
        std::uint32_t across = PatchBorders::kNone;
        for (const std::uint32_t other : others->second) {
            const Patch& beyond = patches[borders.pieces[other].patch];
            const double cosine = glm::dot(patch.normal, beyond.normal);
            const bool isTaken =
                borders.pieces[other].across != PatchBorders::kNone || borders.pieces[other].patch == here.patch;
            if (isTaken || faces.all[beyond.face].material != face.material || !(cosine > flattest)) continue;
            flattest = cosine;
            across = other;
        }
        if (across == PatchBorders::kNone) continue;
        const dvec3 middle = 0.5 * (borders.pointsCentred[here.point] + borders.pointsCentred[endOf(piece)]);
        if (isContact(faces, contacts, patch.face, patches[borders.pieces[across].patch].face, middle,
                      scales.touching[face.object])) {
            borders.parted.push_back(std::minmax(here.patch, std::uint32_t{borders.pieces[across].patch}));
            continue;
        }
        here.across = across;
        borders.pieces[across].across = piece;
    }
    std::ranges::sort(borders.parted);
    const auto repeated = std::ranges::unique(borders.parted);
    borders.parted.erase(repeated.begin(), repeated.end());
    return borders;
}

} // namespace shadowlab::radiosity
