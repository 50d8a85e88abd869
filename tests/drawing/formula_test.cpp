// Formulas: what is read, how large it is, and what is said of what cannot be read.
// SPDX-License-Identifier: MIT
#include "app/drawing/formula.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "app/context/assets.h"
#include "app/drawing/prose.h"
#include "techniques/foundation/base/error.h"

namespace shadowlab::drawing {
namespace {

class FormulaTest : public ::testing::Test {
protected:
    [[nodiscard]] Extent measured(const std::string& tex) const { return Formula(tex).measure(40, {upright_, bold_}); }
    [[nodiscard]] std::vector<TextLine> lettersOf(const std::string& tex) const {
        Drawing drawing({1000, 1000});
        Formula(tex).draw(drawing, {100, 500}, 40, "#000000", {upright_, bold_});
        std::vector<TextLine> letters;
        for (const Mark& mark : drawing.marks())
            if (const auto* text = std::get_if<TextLine>(&mark)) letters.push_back(*text);
        return letters;
    }
    image::Font upright_{context::assetsRoot() / "fonts" / "DejaVuSans.ttf"};
    image::Font bold_{context::assetsRoot() / "fonts" / "DejaVuSans-Bold.ttf"};
};

TEST_F(FormulaTest, IsSpokenInOneLine) {
    EXPECT_EQ(Formula(R"(\mathbf{N} \cdot \mathbf{P}' + D = 0)").spoken(), "N · P′ + D = 0");
    EXPECT_EQ(Formula(R"(F_{jk} = \frac{1}{A_j})").spoken(), "F_jk = (1) / (A_j)");
    EXPECT_EQ(Formula(R"(\sqrt{1 - x^2})").spoken(), "√(1 − x^2)");
    EXPECT_EQ(Formula(R"(\begin{bmatrix} a & b \\ c & d \end{bmatrix})").spoken(), "[a, b; c, d]");
}

TEST_F(FormulaTest, IsMarkupThatABrowserSets) {
    const auto variable = [](const std::string& letter) { return "<mi mathvariant=\"normal\" class=\"variable\">" + letter + "</mi>"; };
    EXPECT_EQ(Formula("n_f").mathML(false),
              "<math><mrow><msub>" + variable("n") + variable("f") + "</msub></mrow></math>");
    EXPECT_NE(Formula("F_{ii} = 0").mathML(false).find("<msub>" + variable("F") + "<mrow>" + variable("i") + variable("i") + "</mrow>"),
              std::string::npos);
    EXPECT_NE(Formula(R"(\frac{1}{A_j})").mathML(true).find("<math display=\"block\"><mrow><mfrac><mrow><mn>1</mn></mrow>"),
              std::string::npos);
    EXPECT_NE(Formula(R"(\mathbf{N})").mathML(false).find("class=\"vector\">N</mi>"), std::string::npos);
    EXPECT_NE(Formula(R"(\begin{bmatrix} a & b \\ c & d \end{bmatrix})").mathML(false).find("</mtd></mtr><mtr><mtd>"), std::string::npos);
    EXPECT_NE(Formula("x < -1").mathML(false).find("<mo form=\"infix\">&lt;</mo><mo form=\"prefix\" lspace=\"0\" rspace=\"0\">−</mo>"),
              std::string::npos)
        << "the second sign belongs to the number";
    // Every element that is opened is closed, also in what nests.
    for (const std::string tex : {R"(\sum_{k=1}^{n} x_k^2)", R"(\left( \sqrt{x} \right. \cos^2 \phi)", R"(\iint_A \text{a b} \, dA)"}) {
        const std::string markup = Formula(tex).mathML(true);
        EXPECT_EQ(std::ranges::count(markup, '<') % 2, 0) << markup;
        EXPECT_EQ(markup.find("\\"), std::string::npos) << "no TeX is left: " << markup;
    }
    EXPECT_EQ(proseMarkup("a < $d$"), "a &lt; " + Formula("d").mathML(false));
}

TEST_F(FormulaTest, PartsStandWhereTheyBelong) {
    const auto scripts = lettersOf("x_a^b");
    ASSERT_EQ(scripts.size(), 3u);
    EXPECT_GT(scripts[1].place.y, scripts[0].place.y) << "lowered";
    EXPECT_LT(scripts[2].place.y, scripts[0].place.y) << "raised";
    EXPECT_LT(scripts[1].style.size, scripts[0].style.size);
    EXPECT_EQ(scripts[1].place.x, scripts[2].place.x) << "one above the other";
    const auto fraction = lettersOf(R"(\frac{1}{22})");
    ASSERT_EQ(fraction.size(), 2u);
    EXPECT_LT(fraction[0].place.y, fraction[1].place.y);
    EXPECT_GT(fraction[0].place.x, fraction[1].place.x) << "centred over the longer one";
    const auto vector = lettersOf(R"(\mathbf{N} n 2)");
    ASSERT_EQ(vector.size(), 3u);
    EXPECT_TRUE(vector[0].style.isBold && !vector[0].style.isItalic);
    EXPECT_TRUE(vector[1].style.isItalic);
    EXPECT_FALSE(vector[2].style.isItalic);
}

// What is drawn lies within what was measured, so that nothing of it covers a neighbour.
TEST_F(FormulaTest, LettersLieWithinWhatIsMeasured) {
    int letters = 0;
    for (const std::string tex :
         {R"(\mathbf{P}' = \mathbf{P} + d \frac{\mathbf{P} - \mathbf{P}_L}{|\mathbf{P} - \mathbf{P}_L|})",
          R"(F_{jk} = \frac{1}{A_j} \int_{A_j} \int_{A_k} \frac{\cos\phi_j \cos\phi_k}{\pi r^2} dA_k dA_j)",
          R"(B_i = E_i + \rho_i \sum_{k=1}^{n} B_k F_{ik})", R"(\left(\frac{a}{b}\right)^2 + \sqrt{x})",
          R"(\begin{bmatrix} 1 & 2 & 3 \\ 4 & 5 & 6 \end{bmatrix})"}) {
        const Extent extent = measured(tex);
        for (const TextLine& letter : lettersOf(tex)) {
            ++letters;
            EXPECT_GE(letter.place.x, 100) << tex;
            EXPECT_LE(letter.place.x, 100 + extent.width) << tex;
            EXPECT_GE(letter.place.y, 500 - extent.above) << tex;
            EXPECT_LE(letter.place.y, 500 + extent.below) << tex;
        }
    }
    EXPECT_GT(letters, 60);
}

TEST_F(FormulaTest, AMinusIsASignOrAnOperation) {
    // Around an operation there is space, between a sign and its number there is none.
    const auto operation = lettersOf("a - 1"), sign = lettersOf("-1");
    ASSERT_EQ(operation.size(), 3u);
    ASSERT_EQ(sign.size(), 2u);
    EXPECT_GT(operation[2].place.x - operation[1].place.x, sign[1].place.x - sign[0].place.x + 5);
}

TEST_F(FormulaTest, AFunctionKeepsAwayFromWhatItIsMultipliedBy) {
    const double blank = measured("I\\cos x").width - measured("I").width - measured("\\cos x").width;
    EXPECT_NEAR(blank, 40.0 / 6, 0.5) << "a sixth of an em, as on its other side; letters are measured in whole thousandths";
    EXPECT_NEAR(measured("+\\cos x").width, measured("+").width + measured("\\cos x").width, 0.5) << "a sign has its own";
}

TEST_F(FormulaTest, FaultsAreToldWithTheirColumn) {
    const std::pair<const char*, const char*> cases[] = {
        {"a_", "column 3"},
        {R"(\frc{a}{b})", "\"frac\""},
        {"{a", "write }"},
        {"a}", "column 2"},
        {R"(\left(a)", "write \\right"},
        {"^2", "column 1"},
        {R"(\begin{bmatrix} a & b \\ c \end{bmatrix})", "as long as the first"},
    };
    int told = 0;
    for (const auto& [tex, message] : cases) {
        try {
            Formula formula(tex);
            ADD_FAILURE() << tex << " was taken";
        } catch (const Error& error) {
            EXPECT_EQ(error.status(), ExitStatus::badInput);
            EXPECT_NE(std::string(error.what()).find(message), std::string::npos) << error.what();
            ++told;
        }
    }
    EXPECT_EQ(told, 7);
    EXPECT_THROW(Formula(std::string(5000, '{')), Error) << "not out of stack";
}

} // namespace
} // namespace shadowlab::drawing
