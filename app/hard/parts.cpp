// SPDX-License-Identifier: MIT
#include "app/hard/parts.h"

#include <fstream>
#include <iterator>

#include "app/hard/results_json.h"
#include "app/report/store.h"
#include "app/session/digest.h"
#include "app/session/program_digest.h"
#include "techniques/foundation/error.h"
#include "techniques/foundation/image/output_file.h"
#include "techniques/foundation/image/output_folder.h"

namespace shadowlab::hard {

namespace {

namespace fs = std::filesystem;

std::string textOf(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

} // namespace

Parts::Parts(fs::path folder, std::string madeBy) : folder_(std::move(folder)), madeBy_(std::move(madeBy)) {
    image::makeFolders(folder_ / "parts");
    image::makeFolders(folder_ / "pictures");
}

fs::path Parts::fileOf(const Case& one) const { return folder_ / "parts" / (report::fileName(one.id) + ".json"); }

std::string Parts::madeFrom(const Case& one) const {
    std::string text = madeBy_ + "\n" + textOf(one.file);
    if (one.picture) text += session::digestOf(*one.picture->scene);
    for (const Check& check : one.checks) {
        text += " " + session::digestOf(*check.right.scene);
        for (const Expectation& expected : check.expectations)
            if (expected.from) text += " " + session::digestOf(*expected.from->scene);
    }
    return text;
}

std::optional<CaseResult> Parts::find(const Case& one) const {
    std::error_code ignored;
    if (!fs::is_regular_file(fileOf(one), ignored)) return std::nullopt;
    try {
        const Json part = Json::parse(textOf(fileOf(one)));
        if (part.at("madeFrom") != madeFrom(one)) return std::nullopt;
        for (const auto& [picture, digest] : part.at("pictures").items())
            if (session::digestOf(textOf(folder_ / "pictures" / picture)) != digest) return std::nullopt;
        return caseResultFromJson(part.at("result"));
    } catch (const Json::exception&) {
        return std::nullopt; // nothing is lost but the time to run the case again
    }
}

void Parts::keep(const Case& one, const CaseResult& result) const {
    Json digests = Json::object();
    const auto write = [&](const Pictures& pictures) {
        if (pictures.name.empty()) return;
        for (const auto& [ending, png] :
             {std::pair(".png", &pictures.picturePng), {"-errors.png", &pictures.errorPng}}) {
            image::writeWhole(folder_ / "pictures" / (pictures.name + ending), *png);
            digests[pictures.name + ending] = session::digestOf(*png);
        }
    };
    for (const Row& row : result.rows) {
        write(row.right);
        if (row.naive) write(*row.naive);
    }
    for (const Cell& cell : result.cells)
        write(cell.pictures);
    // Last: with it the case counts as known.
    const Json part{{"madeFrom", madeFrom(one)}, {"pictures", digests}, {"result", toJson(result)}};
    image::writeWhole(fileOf(one), part.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
}

void Parts::discard(std::span<const Case> cases) const {
    std::error_code ignored; // what stays is found to be old, or used again: neither does harm
    for (const Case& one : cases)
        fs::remove(fileOf(one), ignored);
    fs::remove(folder_ / "parts", ignored); // not where a report has its parts there
}

std::string madeBy(const std::string& renderer, bool small, std::span<const Column> columns) {
    std::string text = session::programDigest() + ", " + renderer + (small ? ", small" : ", full size");
    for (const Column& column : columns)
        text += ", " + column.title();
    return text;
}

} // namespace shadowlab::hard
