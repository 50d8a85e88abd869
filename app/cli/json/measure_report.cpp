// SPDX-License-Identifier: MIT
#include "app/cli/json/measure_report.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>

#include "app/cli/json/json_values.h"
#include "app/cli/text_table.h"

namespace shadowlab::cli {

namespace {

using Result = report::TechniqueErrors;

/// What a technique is judged by.
Json shareErrorsJson(const judge::ShareErrors& errors) {
    return {{"pixels", errors.pixels}, {"rmse", errors.rmse}, {"mean", errors.mean}, {"max", errors.largest}};
}

/// Only of a measurement that was asked for it.
Json coverageJson(const judge::CoverageErrors& errors) {
    return {{"points", errors.points},
            {"samples", errors.samples},
            {"all", shareErrorsJson(errors.all)},
            {"edge", shareErrorsJson(errors.edge)},
            {"outline", shareErrorsJson(errors.outline)}};
}

Json resultJson(const Measured& measured, const Result& result) {
    const judge::Counts& counts = result.counts;
    Json entry;
    entry["technique"] = result.technique;
    entry["light"] = measured.light;
    entry["truth"] = truthName(result.truth);
    entry["pixels"] = counts.pixels;
    entry["lit"] = counts.lit;
    entry["shadowed"] = counts.shadowed;
    entry["turnedAway"] = counts.turnedAway;
    entry["ties"] = counts.ties;
    entry["served"] = result.served;
    entry["falseLit"] = counts.falseLit;
    entry["falseShadow"] = counts.falseShadow;
    entry["coreErrors"] = result.coreErrors;
    entry["stray"] = counts.stray;
    entry["edgeErrorPx"] = numberJson(result.edgeErrorPx);
    entry["boundaryPx"] = displacementJson(result.boundaryPx);
    entry["rmse"] = counts.rmse;
    if (result.coverage) entry["coverage"] = coverageJson(*result.coverage);
    entry["psnr"] = numberJson(result.picture.psnr);
    entry["ssim"] = numberJson(result.picture.ssim);
    entry["flip"] = numberJson(result.picture.flip);
    entry["excessFlipRate"] = numberJson(result.excessFlipRate);
    entry["converged"] = result.converged;
    entry["ms"] = timesJson(result.times);
    entry["ms"]["firstPrepare"] = result.firstPrepareMs;
    entry["counters"] = countersJson(result.counters);
    return entry;
}

std::string fixed(double value, int decimals) {
    std::array<char, 64> buffer{};
    const auto [end, error] =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, decimals);
    return error == std::errc{} ? std::string(buffer.data(), end) : std::string("?");
}

std::string fixed(const std::optional<double>& value, int decimals) { return value ? fixed(*value, decimals) : "-"; }

std::string percent(int part, int whole) { return whole > 0 ? fixed(100.0 * part / whole, 2) + " %" : "-"; }

/// What the truth says: of the light's centre, of its area, or of both where techniques are judged by different ones.
Rows truthRows(const Measured& measured) {
    Rows rows{{"truth"}, {"lit"}, {"in shadow"}, {"turned away"}, {"ties"}, {"with a surface"}, {"made in ms"}};
    rows.back().push_back(fixed(measured.truthMs, 1));
    for (const judge::TruthOf truth : {judge::TruthOf::centre, judge::TruthOf::area}) {
        const auto found = std::ranges::find(measured.results, truth, &Result::truth);
        if (found == measured.results.end()) continue;
        const judge::Counts& counts = found->counts;
        rows[0].insert(rows[0].end(), {std::string(truthName(truth)) + ", pixels", "share"});
        const std::array parts = {counts.lit, counts.shadowed, counts.turnedAway, counts.ties};
        for (std::size_t i = 0; i < parts.size(); ++i)
            rows[i + 1].insert(rows[i + 1].end(), {std::to_string(parts[i]), percent(parts[i], counts.pixels)});
        rows[5].insert(rows[5].end(), {std::to_string(counts.pixels), ""});
    }
    for (std::vector<std::string>& row : rows)
        row.emplace_back(); // numbers stand right, but for the last column
    return rows;
}

Rows errorRows(const Measured& measured) {
    Rows rows{{"errors", "truth", "false lit", "false shadow", "core", "edge error px", "boundary px mean", "p95",
               "max", "RMSE", "served", measured.frames > 1 ? "excess flips" : ""}};
    for (const Result& result : measured.results) {
        const auto& boundary = result.boundaryPx;
        rows.push_back({result.technique, truthName(result.truth), std::to_string(result.counts.falseLit),
                        std::to_string(result.counts.falseShadow), std::to_string(result.coreErrors),
                        fixed(result.edgeErrorPx, 4), boundary ? fixed(boundary->mean, 3) : "-",
                        boundary ? fixed(boundary->p95, 2) : "-", boundary ? fixed(boundary->max, 2) : "-",
                        fixed(result.counts.rmse, 4), fixed(100 * result.served, 1) + " %",
                        measured.frames > 1 ? fixed(result.excessFlipRate, 4) : ""});
    }
    return rows;
}

/// The heading says what of each pixel was compared.
Rows coverageRows(const Measured& measured) {
    const judge::CoverageErrors& asked = *measured.results.front().coverage;
    const std::string samples = asked.samples == 1
                                    ? "visibility at its centre"
                                    : "the mean of " + std::to_string(asked.samples) + " x " + std::to_string(asked.samples) + " samples";
    Rows rows{{"share of a pixel: " + samples + " against " + std::to_string(asked.points) + (asked.points == 1 ? " point" : " points"),
               "edge pixels", "RMSE", "mean", "max", "all pixels", "RMSE", "mean", "max", "outline pixels", "RMSE", ""}};
    for (const Result& result : measured.results) {
        const judge::CoverageErrors& errors = *result.coverage;
        std::vector<std::string> row{result.technique};
        for (const judge::ShareErrors* const part : {&errors.edge, &errors.all})
            row.insert(row.end(), {std::to_string(part->pixels), fixed(part->rmse, 4), fixed(part->mean, 4), fixed(part->largest, 3)});
        row.insert(row.end(), {std::to_string(errors.outline.pixels), fixed(errors.outline.rmse, 4), ""});
        rows.push_back(std::move(row));
    }
    rows.push_back({"made in ms", fixed(measured.coverageMs, 1)});
    rows.back().resize(rows.front().size());
    return rows;
}

Rows pictureRows(const Measured& measured) {
    Rows rows{{"picture against ray-traced", "PSNR dB", "SSIM", "FLIP", ""}};
    for (const Result& result : measured.results)
        rows.push_back({result.technique, std::isfinite(result.picture.psnr) ? fixed(result.picture.psnr, 2) : "equal",
                        fixed(result.picture.ssim, 5), fixed(result.picture.flip, 5), ""});
    return rows;
}

Rows timeRows(const Measured& measured) {
    Rows rows{{"ms", "frame", "prepare", "first prepare", "passes"}};
    for (const Result& result : measured.results) {
        std::string passes;
        for (const gl::PassTimer::Result& pass : result.times.passMs())
            passes += (passes.empty() ? "" : ", ") + pass.name + " " + fixed(pass.elapsedMs, 1);
        rows.push_back({result.technique, fixed(result.times.frameMs(), 1), fixed(result.times.prepareMs(), 1),
                        fixed(result.firstPrepareMs, 1), passes});
    }
    return rows;
}

Rows counterRows(const Measured& measured) {
    Rows rows{{"counters", ""}};
    for (const Result& result : measured.results) {
        std::string counters;
        for (const Counter& counter : result.counters) {
            counters += (counters.empty() ? "" : ", ") + counter.id + " " + fixed(counter.built, 0);
            if (counter.of > 0) counters += " of " + fixed(counter.of, 0);
            if (!counter.unit.empty()) counters += " " + counter.unit;
        }
        rows.push_back({result.technique, counters});
    }
    return rows;
}

} // namespace

std::string measureJson(const Measured& measured) {
    Json root;
    root["scene"] = measured.scene;
    root["size"] = {measured.size.x, measured.size.y};
    root["backend"] = measured.backend;
    root["renderer"] = measured.renderer;
    root["frames"] = measured.frames;
    root["truthMs"] = measured.truthMs;
    if (measured.results.front().coverage) root["coverageMs"] = measured.coverageMs;
    root["results"] = Json::array();
    for (const Result& result : measured.results)
        root["results"].push_back(resultJson(measured, result));
    // A file's name may hold bytes that are no UTF-8; JSON may not.
    return root.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string measureTable(const Measured& measured, std::optional<std::size_t> columns) {
    const std::string heading = measured.scene + ", light '" + measured.light + "', " + std::to_string(measured.size.x) + "x" +
                                std::to_string(measured.size.y) + ", " + std::to_string(measured.frames) +
                                (measured.frames == 1 ? " frame" : " frames") + ", " + measured.renderer;
    std::string text = fitting(heading + "\n", columns);
    std::vector<Rows> tables{truthRows(measured), errorRows(measured)};
    if (measured.results.front().coverage) tables.push_back(coverageRows(measured));
    tables.insert(tables.end(), {pictureRows(measured), timeRows(measured), counterRows(measured)});
    for (const Rows& rows : tables)
        text += "\n" + aligned(rows, columns);
    return text;
}

} // namespace shadowlab::cli
