// Reads the small part of TeX that formula.h describes.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <optional>

#include "app/drawing/formula_tree.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/base/nearest_names.h"

namespace shadowlab::drawing {

namespace {

using Node = Formula::Node;
using Kind = Node::Kind;

struct Sign {
    std::string_view name, text;
    Kind kind;
};
constexpr std::array kSigns{
    Sign{"cdot", "·", Kind::operation},  Sign{"times", "×", Kind::operation}, Sign{"le", "≤", Kind::operation},
    Sign{"ge", "≥", Kind::operation},    Sign{"ne", "≠", Kind::operation},    Sign{"approx", "≈", Kind::operation},
    Sign{"to", "→", Kind::operation},    Sign{"in", "∈", Kind::operation},    Sign{"pm", "±", Kind::operation},
    Sign{"infty", "∞", Kind::upright},   Sign{"ldots", "…", Kind::upright},   Sign{"cdots", "⋯", Kind::upright},
    Sign{"vdots", "⋮", Kind::upright},   Sign{"ddots", "⋱", Kind::upright},   Sign{"alpha", "α", Kind::variable},
    Sign{"beta", "β", Kind::variable},   Sign{"gamma", "γ", Kind::variable},  Sign{"delta", "δ", Kind::variable},
    Sign{"eta", "η", Kind::variable},    Sign{"theta", "θ", Kind::variable},  Sign{"kappa", "κ", Kind::variable},
    Sign{"lambda", "λ", Kind::variable}, Sign{"mu", "μ", Kind::variable},     Sign{"pi", "π", Kind::variable},
    Sign{"rho", "ρ", Kind::variable},    Sign{"sigma", "σ", Kind::variable},  Sign{"phi", "φ", Kind::variable},
    Sign{"omega", "ω", Kind::variable},  Sign{"Delta", "Δ", Kind::upright},   Sign{"Phi", "Φ", Kind::upright},
    Sign{"Omega", "Ω", Kind::upright},   Sign{"cos", "cos", Kind::function},  Sign{"sin", "sin", Kind::function},
    Sign{"max", "max", Kind::function},  Sign{"min", "min", Kind::function},  Sign{"exp", "exp", Kind::function},
    Sign{"log", "log", Kind::function},  Sign{"sum", "∑", Kind::large},       Sign{"int", "∫", Kind::large},
    Sign{"iint", "∬", Kind::large},      Sign{"prime", "′", Kind::upright},   Sign{"degree", "°", Kind::upright},
};
// What is no sign but a way to put others together.
constexpr std::array kForms{"frac", "sqrt", "mathbf", "text", "left", "begin", "quad"};

class Reader {
public:
    explicit Reader(std::string_view tex) : tex_(tex) {}

    Node whole() {
        Node row = readRow();
        if (at_ < tex_.size()) fail("'" + std::string(1, tex_[at_]) + "' closes nothing; leave it out");
        return row;
    }

private:
    [[noreturn]] void fail(const std::string& what) const {
        throw Error(ExitStatus::badInput, "formula, column " + std::to_string(at_ + 1) + ": " + what);
    }
    void skipBlanks() {
        while (at_ < tex_.size() && tex_[at_] == ' ')
            ++at_;
    }
    /// Does the text go on with that? Then it is taken.
    bool takes(std::string_view word) {
        if (!tex_.substr(at_).starts_with(word)) return false;
        at_ += word.size();
        return true;
    }
    /// Ends at what the caller has to take: } & \\ \right \end, or the end of the text.
    Node readRow() {
        constexpr std::size_t kDeepest =
            40; // formulas for people are not deep; a file is no reason to run out of stack
        if (++depth_ > kDeepest) fail("is nested too deep; write it flatter");
        Node row;
        for (skipBlanks(); at_ < tex_.size(); skipBlanks()) {
            const std::string_view rest = tex_.substr(at_);
            if (rest[0] == '}' || rest[0] == '&' || rest.starts_with("\\\\") || rest.starts_with("\\right") ||
                rest.starts_with("\\end"))
                break;
            row.children.push_back(withScripts(atom()));
        }
        --depth_;
        return row;
    }
    Node group() {
        skipBlanks();
        if (!takes("{")) return atom();
        Node row = readRow();
        if (!takes("}")) fail("a { is not closed; write }");
        return row;
    }
    Node withScripts(Node base) {
        std::optional<Node> low, high;
        std::string primes;
        for (skipBlanks(); at_ < tex_.size(); skipBlanks()) {
            if (takes("'")) {
                primes += "′";
            } else if (!low && takes("_")) {
                low = group();
            } else if (!high && takes("^")) {
                high = group();
            } else {
                break;
            }
        }
        base.text += primes; // the sign is high enough by itself
        if (base.kind == Kind::large) {
            base.children = {low.value_or(Node{}), high.value_or(Node{})};
            return base;
        }
        if (!low && !high) return base;
        Node node{Kind::scripts, "", 0, 0, false, {}};
        node.children = {std::move(base), low.value_or(Node{}), high.value_or(Node{})};
        return node;
    }
    Node atom() {
        skipBlanks();
        if (at_ >= tex_.size()) fail("something is missing here; write a letter, or {...}");
        const char c = tex_[at_];
        if (c == '{') return group();
        if (c == '\\') return command();
        if (c == '_' || c == '^' || c == '}' || c == '&')
            fail("'" + std::string(1, c) + "' stands after a sign; write one before it");
        if ((c >= '0' && c <= '9') || c == '.') {
            const std::size_t begin = at_;
            while (at_ < tex_.size() && ((tex_[at_] >= '0' && tex_[at_] <= '9') || tex_[at_] == '.'))
                ++at_;
            return {Kind::upright, std::string(tex_.substr(begin, at_ - begin)), 0, 0, false, {}};
        }
        std::size_t length = 1; // of the character in UTF-8
        while (at_ + length < tex_.size() && (static_cast<unsigned char>(tex_[at_ + length]) & 0xc0) == 0x80)
            ++length;
        const std::string text(tex_.substr(at_, length));
        at_ += length;
        if (text == "-") return {Kind::operation, "−", 0, 0, false, {}};
        if (text == "+" || text == "=" || text == "<" || text == ">") return {Kind::operation, text, 0, 0, false, {}};
        if (text == "," || text == ";") return {Kind::mark, text, 0, 0, false, {}};
        if (text == "(" || text == "[") return {Kind::opening, text, 0, 0, false, {}};
        if (text == ")" || text == "]" || text == "|" || text == "/" || text == ":" || text == "!")
            return {Kind::upright, text, 0, 0, false, {}};
        return {Kind::variable, text, 0, 0, false, {}};
    }
    std::string words() {
        if (!takes("{")) fail("words stand in {...}; write {");
        const std::size_t end = tex_.find('}', at_);
        if (end == std::string_view::npos) fail("a { is not closed; write }");
        std::string text(tex_.substr(at_, end - at_));
        at_ = end + 1;
        return text;
    }
    Node command() {
        ++at_;
        if (takes(",")) return {Kind::space, "", 1.0 / 6, 0, false, {}};
        if (takes(";")) return {Kind::space, "", 5.0 / 18, 0, false, {}};
        std::size_t end = at_;
        while (end < tex_.size() && ((tex_[end] >= 'a' && tex_[end] <= 'z') || (tex_[end] >= 'A' && tex_[end] <= 'Z')))
            ++end;
        const std::string name(tex_.substr(at_, end - at_));
        const auto sign = std::ranges::find(kSigns, name, &Sign::name);
        if (sign == kSigns.end() && std::ranges::find(kForms, name) == kForms.end()) {
            std::vector<std::string> known(kForms.begin(), kForms.end());
            for (const Sign& s : kSigns)
                known.emplace_back(s.name);
            fail("\\" + name + " is not known; " + suggestion(name, known));
        }
        at_ = end;
        if (sign != kSigns.end()) return {sign->kind, std::string(sign->text), 0, 0, name == "sum", {Node{}, Node{}}};
        if (name == "quad") return {Kind::space, "", 1, 0, false, {}};
        if (name == "text") return {Kind::upright, words(), 0, 0, false, {}};
        if (name == "mathbf") return {Kind::bold, words(), 0, 0, false, {}};
        if (name == "begin") return matrix();
        if (name == "left") return fenced();
        Node node{name == "frac" ? Kind::fraction : Kind::root, "", 0, 0, false, {}};
        node.children.push_back(group());
        if (name == "frac") node.children.push_back(group());
        return node;
    }
    std::string fence() {
        if (at_ < tex_.size() && std::string_view("()[]|.").find(tex_[at_]) != std::string_view::npos)
            return std::string(1, tex_[at_++]);
        fail("after \\left and \\right stands one of ( ) [ ] | or a full stop; write it");
    }
    Node fenced() {
        Node node{Kind::fenced, fence(), 0, 0, false, {}};
        node.children.push_back(readRow());
        if (!takes("\\right")) fail("\\left is not closed; write \\right");
        node.text += fence();
        return node;
    }
    Node matrix() {
        if (words() != "bmatrix") fail("of \\begin only {bmatrix} is known; write it");
        Node node{Kind::matrix, "", 0, 1, false, {}};
        int column = 1;
        for (;;) {
            node.children.push_back(readRow());
            if (takes("&")) {
                ++column;
                continue;
            }
            const bool isFirstRow = static_cast<int>(node.children.size()) == column;
            if (isFirstRow) node.columns = column;
            if (column != node.columns) fail("a row of the matrix is not as long as the first; write as many");
            if (!takes("\\\\")) break;
            column = 1;
        }
        if (!takes("\\end") || words() != "bmatrix") fail("\\begin{bmatrix} is not closed; write \\end{bmatrix}");
        return node;
    }

    std::string_view tex_;
    std::size_t at_ = 0, depth_ = 0;
};

} // namespace

Node parseFormula(std::string_view tex) { return Reader(tex).whole(); }

} // namespace shadowlab::drawing
