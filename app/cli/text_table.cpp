// SPDX-License-Identifier: MIT
#include "app/cli/text_table.h"

#include <algorithm>
#include <numeric>
#include <sstream>

namespace shadowlab::cli {

namespace {

/// Characters, not bytes: names may be of any language.
std::size_t width(const std::string& text) {
    return static_cast<std::size_t>(std::ranges::count_if(text, [](char c) { return (c & 0xc0) != 0x80; }));
}

constexpr std::size_t kGap = 2; ///< blanks between two columns of a list
// Narrower, a column of words is a column of single words.
constexpr std::size_t kNarrowest = 18;

/// A text in the pieces between which a line may end: after blanks, and within a long word after | / and commas.
std::vector<std::string> piecesOf(const std::string& text, std::size_t columns) {
    std::vector<std::string> pieces;
    std::istringstream words(text);
    for (std::string word; words >> word;) {
        const bool isLong = width(word) > columns;
        pieces.emplace_back();
        for (const char c : word) {
            pieces.back() += c;
            if (isLong && (c == '|' || c == '/' || c == ',')) pieces.emplace_back();
        }
        if (pieces.back().empty()) pieces.pop_back();
        pieces.back() += ' ';
    }
    if (!pieces.empty()) pieces.back().pop_back();
    return pieces;
}

std::string withoutBlankAtEnd(const std::string& line) { return line.substr(0, line.find_last_not_of(' ') + 1); }

/// The width of each column of a list so that all fit, the widest made narrower; none where that cannot be.
std::vector<std::size_t> fittingWidths(const Rows& rows, std::size_t columns) {
    std::vector<std::size_t> widths, least;
    for (const std::vector<std::string>& row : rows) {
        widths.resize(std::max(widths.size(), row.size()));
        least.resize(widths.size());
        for (std::size_t i = 0; i < row.size(); ++i) {
            widths[i] = std::max(widths[i], width(row[i]));
            for (const std::string& piece : piecesOf(row[i], kNarrowest))
                least[i] = std::max(least[i], width(withoutBlankAtEnd(piece)));
        }
    }
    for (std::size_t i = 0; i < widths.size(); ++i)
        least[i] = std::min(widths[i], std::max(least[i], kNarrowest));
    const auto total = [&] { return std::reduce(widths.begin(), widths.end()) + kGap * (widths.size() - 1); };
    while (!widths.empty() && total() > columns) {
        std::size_t widest = widths.size(); // of those that may still become narrower
        for (std::size_t i = 0; i < widths.size(); ++i)
            if (widths[i] > least[i] && (widest == widths.size() || widths[i] > widths[widest])) widest = i;
        if (widest == widths.size()) return {};
        --widths[widest];
    }
    return widths;
}

std::string joinedLine(const std::vector<std::string>& cells, const std::vector<std::size_t>& widths) {
    std::string line;
    for (std::size_t i = 0; i < cells.size(); ++i)
        line += cells[i] +
                std::string(i + 1 < cells.size() ? widths[i] - std::min(widths[i], width(cells[i])) + kGap : 0, ' ');
    return withoutBlankAtEnd(line) + "\n";
}

/// A row whose cells take as many lines as the longest of them.
std::string rowLines(const std::vector<std::string>& row, const std::vector<std::size_t>& widths) {
    std::vector<std::vector<std::string>> cells;
    std::size_t lines = 1;
    for (std::size_t i = 0; i < row.size(); ++i) {
        cells.push_back(wrapped(row[i], widths[i]));
        lines = std::max(lines, cells.back().size());
    }
    std::string text;
    for (std::size_t line = 0; line < lines; ++line) {
        std::vector<std::string> parts;
        for (const std::vector<std::string>& cell : cells)
            parts.push_back(line < cell.size() ? cell[line] : "");
        text += joinedLine(parts, widths);
    }
    return text;
}

/// A row as a paragraph: what does not fit beside one another stands below one another.
std::string paragraph(const std::vector<std::string>& headings, const std::vector<std::string>& row,
                      std::size_t columns) {
    constexpr std::size_t kIndent = 4;
    std::string text = row.front() + "\n";
    for (std::size_t i = 1; i < row.size(); ++i) {
        if (row[i].empty()) continue;
        for (const std::string& line : wrapped(headings[i] + ": " + row[i], columns - kIndent))
            text += std::string(kIndent, ' ') + line + "\n";
    }
    return text;
}

/// Which columns of a table stand beside one another, so that none is wider than the terminal: the first one is in all of these parts.
std::vector<std::vector<std::size_t>> partsOf(std::vector<std::size_t>& widths, std::size_t columns) {
    widths[0] = std::min(widths[0], std::max(kNarrowest, columns / 2));
    std::vector<std::vector<std::size_t>> parts{{0}};
    std::size_t taken = widths[0];
    for (std::size_t i = 1; i < widths.size(); ++i) {
        if (widths[i] == 0) continue;
        // Words at the end of a row may be broken, numbers may not.
        const std::size_t needed = kGap + (i + 1 == widths.size() ? std::min(widths[i], 2 * kNarrowest) : widths[i]);
        if (taken + needed > columns && parts.back().size() > 1) {
            parts.push_back({0});
            taken = widths[0];
        }
        parts.back().push_back(i);
        if (i + 1 == widths.size()) widths[i] = std::min(widths[i], std::max(columns, taken + kGap + 1) - taken - kGap);
        taken += kGap + widths[i];
    }
    return parts;
}

/// A row of one part, its first and last column broken where they are too long.
std::string partLines(const std::vector<std::string>& row, const std::vector<std::size_t>& part, const std::vector<std::size_t>& widths) {
    std::vector<std::vector<std::string>> cells;
    std::size_t lines = 1;
    for (const std::size_t i : part) {
        const bool isText = i == 0 || i + 1 == widths.size();
        const std::string cell = i < row.size() ? row[i] : "";
        cells.push_back(isText ? wrapped(cell, widths[i]) : std::vector{std::string(widths[i] - width(cell), ' ') + cell});
        lines = std::max(lines, cells.back().size());
    }
    std::vector<std::size_t> partWidths;
    for (const std::size_t i : part)
        partWidths.push_back(widths[i]);
    std::string text;
    for (std::size_t line = 0; line < lines; ++line) {
        std::vector<std::string> parts;
        for (const std::vector<std::string>& cell : cells)
            parts.push_back(line < cell.size() ? cell[line] : "");
        text += joinedLine(parts, partWidths);
    }
    return text;
}

bool saysSomethingIn(const std::vector<std::string>& row, const std::vector<std::size_t>& part) {
    return std::ranges::any_of(part, [&](std::size_t i) { return i > 0 && i < row.size() && !row[i].empty(); });
}

} // namespace

std::string aligned(const Rows& rows) {
    std::vector<std::size_t> widths;
    for (const std::vector<std::string>& row : rows) {
        widths.resize(std::max(widths.size(), row.size()));
        for (std::size_t i = 0; i < row.size(); ++i)
            widths[i] = std::max(widths[i], width(row[i]));
    }
    std::string text;
    for (const std::vector<std::string>& row : rows) {
        std::string line;
        for (std::size_t i = 0; i < row.size(); ++i) {
            const std::string gap(widths[i] - width(row[i]), ' ');
            const bool left = i == 0 || i + 1 == widths.size();
            line += (i > 0 ? "  " : "") + (left ? row[i] + gap : gap + row[i]);
        }
        text += withoutBlankAtEnd(line) + "\n";
    }
    return text;
}

std::string aligned(const Rows& rows, std::optional<std::size_t> columns) {
    const std::string whole = aligned(rows);
    std::istringstream lines(whole);
    bool fits = true;
    for (std::string line; columns && std::getline(lines, line);)
        fits = fits && width(line) <= *columns;
    if (fits) return whole;
    std::vector<std::size_t> widths;
    for (const std::vector<std::string>& row : rows) {
        widths.resize(std::max(widths.size(), row.size()));
        for (std::size_t i = 0; i < row.size(); ++i)
            widths[i] = std::max(widths[i], width(withoutBlankAtEnd(row[i])));
    }
    std::string text;
    for (const std::vector<std::size_t>& part : partsOf(widths, *columns)) {
        const bool isFirst = text.empty();
        if (!isFirst) text += "\n";
        for (const std::vector<std::string>& row : rows)
            if (isFirst || saysSomethingIn(row, part)) text += partLines(row, part, widths);
    }
    return text;
}

std::vector<std::string> wrapped(const std::string& text, std::size_t columns) {
    std::vector<std::string> lines;
    for (const std::string& piece : piecesOf(text, columns)) {
        if (lines.empty() || width(lines.back()) + width(withoutBlankAtEnd(piece)) > columns)
            lines.push_back(piece);
        else
            lines.back() += piece;
    }
    for (std::string& line : lines)
        line = withoutBlankAtEnd(line);
    return lines;
}

std::string fitting(const std::string& text, std::optional<std::size_t> columns) {
    if (!columns) return text;
    std::string fitted;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        if (width(line) <= *columns) {
            fitted += line + "\n";
            continue;
        }
        const std::size_t indent = std::min(line.find_first_not_of(' '), line.size()), gap = line.find("  ", indent);
        const std::size_t column = gap == std::string::npos ? gap : line.find_first_not_of(' ', gap);
        const bool hasColumn = column <= *columns / 2;
        const std::size_t begin = hasColumn ? column : indent, below = hasColumn ? column : indent + kGap;
        std::string before = line.substr(0, begin);
        for (const std::string& part : wrapped(line.substr(begin), *columns - std::min(below, *columns - 1))) {
            fitted += before + part + "\n";
            before = std::string(below, ' ');
        }
    }
    return fitted;
}

std::string listed(const std::vector<std::string>& headings, const Rows& rows, std::size_t columns) {
    constexpr std::size_t kLeastColumns = 40;
    columns = std::max(columns, kLeastColumns);
    Rows all{headings};
    all.insert(all.end(), rows.begin(), rows.end());
    std::string text;
    if (const std::vector<std::size_t> widths = fittingWidths(all, columns); !widths.empty()) {
        for (const std::vector<std::string>& row : all)
            text += rowLines(row, widths);
        return text;
    }
    for (const std::vector<std::string>& row : rows)
        text += (text.empty() ? "" : "\n") + paragraph(headings, row, columns);
    return text;
}

} // namespace shadowlab::cli
