// A text of which some parts are replaced, and the rest stays as it is, to the byte.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <string_view>
#include <utility>

namespace shadowlab::scene {

class ReplacedText {
public:
    /// `text` must outlive this.
    explicit ReplacedText(std::string_view text) : text_(text) {}

    /// `part` is a part of the text, behind all that were replaced before.
    void replace(std::string_view part, std::string_view by) {
        const auto at = static_cast<std::size_t>(part.data() - text_.data());
        result_ += text_.substr(done_, at - done_);
        result_ += by;
        done_ = at + part.size();
    }

    [[nodiscard]] std::string finish() && { return std::move(result_ += text_.substr(done_)); }

    /// A string of JSON with its quotes, as it stands in a text that was parsed.
    static std::string_view tokenAt(std::string_view text, std::size_t offset) {
        std::size_t end = offset + 1;
        while (text[end] != '"')
            end += text[end] == '\\' ? 2 : 1;
        return text.substr(offset, end + 1 - offset);
    }

private:
    std::string_view text_;
    std::string result_;
    std::size_t done_ = 0; ///< bytes of the text
};

} // namespace shadowlab::scene
