#include "core/formula/parse.h"
#include "core/formula/formula.h"
#include "core/formula/print.h"
#include "core/formula/syntax_error.h"

#include <gtest/gtest.h>

namespace normalscope::formulas {
namespace {

std::string text_of(std::string_view formula) {
    Graph graph;
    return to_text(graph, parse(graph, formula));
}

bool same(std::string_view a, std::string_view b) {
    Graph graph;
    return parse(graph, a) == parse(graph, b);
}

TEST(FormulaParse, Precedence) {
    for (const auto& [a, b] : std::initializer_list<std::pair<std::string_view, std::string_view>>{
             {"-x^2", "-(x^2)"},
             {"x^-2", "1/(x*x)"},
             {"x^y^z", "x^(y^z)"},
             {"2^-x^2", "2^(-(x^2))"},
             {"1/2x", "x/2"},
             {"1/(2(x+1))", "(1/2)*(1/(x+1))"},
             {"x-y-z", "x-(y+z)"},
             {"x/y/z", "x/(y*z)"},
             {"x - -y", "x+y"},
             {"2*-x", "-2x"},
             {"3(x+y)z", "3*(x+y)*z"},
             {"xy", "x*y"},
             {"x y", "x*y"},
             {"axy", "a*x*y"},
             {"2e x", "2*e*x"},
             {"2e3x", "2000*x"},
             {"2sin x", "2*sin(x)"},
             {"sin 2x cos y", "sin(2*x)*cos(y)"},
             {"sin x y(z+1)", "sin(x*y)*(z+1)"},
             {"sin x^2", "sin(x^2)"},
             {"sin(x)^2", "(sin(x))^2"},
             {"sin^2 x", "(sin(x))^2"},
             {"sin² x", "(sin(x))^2"},
             {"-sin -x y", "sin(x*y)"},
             {"a cos(x)", "a*cos(x)"},
             {"acosx", "acos(x)"},
             {"exp(2x)", "e^(2x)"},
             {"ln x", "log(x)"},
             {"sinh^2 z", "(sinh(z))^2"},
             {"cosh(-x) + sinh(-y) + acosh(1)", "cosh(x) - sinh(y)"},
             {"cos h", "cos(h)"},
             {"asinh(-x) + atanh(0)", "-asinh(x)"},
             {"cot x + sec y", "1/tan(x)+1/cos(y)"},
             {"arctan(y/x)", "atan(y/x)"},
             {"[x{y+1}]^{2}", "(x*(y+1))^2"},
             {"√x y", "sqrt(x)*y"},
             {"|x||y|", "abs(x)*abs(y)"},
             {"2|x|", "2*abs(x)"},
             {"min(x,y,z)", "min(min(x,y),z)"},
             {"x² + y⁻¹·2", "x^2+2/y"},
             {"½x² + 2¼y", "x^2/2+9/4*y"},
             {"x × y − z ÷ 2", "x*y-z/2"},
             {"x**2", "x^2"},
             {"π", "pi"},
             {"x^2 = 1 - y^2", "x^2+y^2-1"},
             {"x^2 + y^2 = 0", "x^2+y^2"},
             {"f(x, y, z) = x + f", "x+f"},
             {"f(x)", "f*x"},
             {"xy(z+1)", "x*y*(z+1)"},
             {"x sin(y)", "xsin(y)"},
             {"log10(x)", "log(x)/log(10)"},
             {"log10 x", "log(x)/log(10)"},
             {"log2(8x)", "log(8x)/log(2)"},
             {"x ln(y)", "x*log(y)"},
             {"pow(x,2)+pow(y, z)", "x^2+y^z"},
             {"cbrt(x)", "x^(1/3)"},
             {"hypot(x,y)", "sqrt(x^2+y^2)"},
             {"hypot(x,y,z)", "sqrt(x^2+y^2+z^2)"},
             {"ceil(x)", "-floor(-x)"},
             {"mod(x, 2y)", "x-2y*floor(x/(2y))"},
             {"heaviside(x)", "(1+sign(x))/2"},
             {"max(x, y, z, 1)", "max(max(max(x, y), z), 1)"},
             {"x^2 == y;", "x^2-y"},
             {"x ; ;\n", "x"},
             {"floor(floor(x)+7/2)", "floor(floor(x)+3.5)"},
             {"floor(-7/2)", "-4"},
             {"mod(-1, 3)", "2"},
             {"2sin2x", "2*sin(2x)"},
         })
        EXPECT_TRUE(same(a, b)) << a << " is " << text_of(a) << ", " << b << " is " << text_of(b);
}

TEST(FormulaParse, ReadsEasily) {
    for (const auto& [given, expected] : std::initializer_list<std::pair<std::string_view, std::string_view>>{
             {"1*x+0", "x"},
             {"x*2", "2x"},
             {"x+x+y-y", "2x"},
             {"x*x*y/x", "xy"},
             {"1/3+1/6", "1/2"},
             {"0.1x", "0.1x"},
             {"x/4", "x/4"},
             {"-1+y^2+x^2", "x^2 + y^2 - 1"},
             {"-x^2+1", "1 - x^2"},
             {"sqrt(8)^2", "8"},
             {"8^(1/3)", "2"},
             {"x sqrt(2) sqrt(2)", "2x"},
             {"x√0.5√0.5", "x/2"},
             {"z|z||z|z^2", "z^5"},
             {"sqrt(sqrt(x))", "x^(1/4)"},
             {"sqrt(x^2)", "sqrt(x^2)"},
             {"(x^2)^(1/3)", "x^(2/3)"},
             {"(-8)^(1/3)", "-2"},
             {"2^(3/2)", "2sqrt(2)"},
             {"sin(pi/2)", "1"},
             {"cos(-x)", "cos(x)"},
             {"exp(log(x))", "x"},
             {"(2x)^3", "8x^3"},
             {"abs(x)^2", "x^2"},
             {"x^2y^2(x+1)", "x^2 y^2(x + 1)"},
             {"2x/(3y)", "2x/(3y)"},
             {"(x+1)/(y-1)", "(x + 1)/(y - 1)"},
             {"3*2^x", "3*2^x"},
             {"a*b*(x+1)", "ab (x + 1)"},
             {"x*y*(z+1)", "xy(z + 1)"},
             {"a*(x+1)", "a(x + 1)"},
             {"atan2(y, -x)", "atan2(y, -x)"},
         })
        EXPECT_EQ(text_of(given), expected) << given;
}

TEST(FormulaParse, PrintsForPeopleAndLatex) {
    Graph graph;
    const Id f = parse(graph, "-2x^2y/3 + sqrt(x+1)/x - 1/2 + pi e^(-x) + 2^(2/3)abs(z)^a");
    EXPECT_EQ(to_unicode(graph, parse(graph, "x^2-y^-2+sqrt(x)*abs(y)/3")), "x² + √x |y|/3 − 1/y²");
    EXPECT_EQ(to_latex(graph, parse(graph, "-x^10/(y+1)")), "-\\frac{x^{10}}{y + 1}");
    EXPECT_EQ(to_latex(graph, parse(graph, "asin(x)/2")), "\\frac{\\arcsin\\left(x\\right)}{2}");
    EXPECT_EQ(parse(graph, to_text(graph, f)), f) << to_text(graph, f);
    EXPECT_EQ(parse(graph, to_unicode(graph, f)), f) << to_unicode(graph, f);
    EXPECT_NE(to_latex(pieces(graph, f, 5)).find("\\ldots"), std::string::npos);
}

TEST(FormulaParse, ErrorsNameTheColumnAndWhatWasExpected) {
    struct Case {
        std::string_view text;
        std::size_t column;
        std::string_view part;
    };
    for (const auto& [text, column, part] : std::initializer_list<Case>{
             {"", 1, "found the end"},
             {"   ", 4, "found the end"},
             {"x +", 4, "expected a number, a name or \"(\", found the end"},
             {"x + * y", 5, "found \"*\""},
             {"(x", 3, "expected \")\" for the one opened at column 1"},
             {"x)", 2, "no \"(\" belongs"},
             {"()", 2, "found \")\""},
             {"|x", 3, "expected \"|\""},
             {"(x|", 4, "found the end"},
             {"foo(x)", 1, "unknown name \"foo\""},
             {"1 + sqr(x)", 5, "did you mean sqrt?"},
             {"2ab(x)", 2, "unknown function \"ab\"; for a product write * before the bracket. Known are: sqrt"},
             {"fabs(x)", 1, "unknown function \"fabs\""},
             {"ch[x]", 1, "unknown function"},
             {"z = sin2(x)", 5, "\"sin2(\" is not a function; write sin(2*(…)), sin(2)*(…) or sin(…)^2."},
             {"exp 3 (x)", 1, "is not a function"},
             {"log10.5(x)", 1, "is not a function"},
             {"atan2(x)", 8, "expected \",\""},
             {"pow(x, y, z)", 9, "2 arguments"},
             {"x; y", 2, "found \";\""},
             {"mod(x, 0)", 1, "no real value"},
             {"π·Sin(x)", 3, "did you mean sin?"},
             {"X^2", 1, "did you mean x?"},
             {"x + w", 5, "unknown name \"w\"; known are: "},
             {"i*x", 1, "unknown name \"i\"; known are: "},
             {"1/0", 2, "divides by zero"},
             {"x/(1-1)", 2, "divides by zero"},
             {"1 + log(-1)", 5, "no real value"},
             {"sqrt(1-2)", 1, "no real value"},
             {"0^-1", 2, "no real value"},
             {"(-2)^x", 5, "no real value"},
             {"9^9^9", 2, "too large"},
             {"1e999", 1, "too large"},
             {"x - exp(1e9)", 5, "too large"},
             {"x - cosh(800)", 5, "too large"},
             {"1..2", 3, "second decimal point"},
             {"2 3", 3, "operator between two numbers"},
             {"x = y = z", 7, "one \"=\""},
             {"min(x)", 6, "expected \",\""},
             {"sin(x, y)", 6, "expected \")\""},
             {"where(x, y)", 11, "3 arguments"},
             {"min x", 5, "expected \"(\" after min"},
             {"sin^-1 x", 5, "asin"},
             {"x, y", 2, "expected an operator"},
             {"x # y", 3, "found \"#\""},
             {"x \xff", 3, "UTF-8"},
             {std::string_view("x\0", 2), 2, "control character"},
         }) {
        try {
            Graph graph;
            parse(graph, text);
            ADD_FAILURE() << text << " was read";
        } catch (const SyntaxError& e) {
            EXPECT_EQ(e.column, column) << text << ": " << e.what();
            EXPECT_NE(std::string_view(e.what()).find(part), std::string_view::npos) << text << ": " << e.what();
            EXPECT_EQ(std::string_view(e.what()).find('\n'), std::string_view::npos);
        }
    }
}

std::string repeated(std::string_view part, std::size_t n) {
    std::string text;
    for (std::size_t i = 0; i < n; ++i) text += part;
    return text;
}

TEST(FormulaParse, TenThousandCharactersAndNoMore) {
    const std::string longest = "x" + repeated("+1", (kMostCharacters - 1) / 2);
    EXPECT_EQ(text_of(longest), "x + 4999");
    EXPECT_THROW(text_of(longest + "+1"), SyntaxError);
    EXPECT_THROW(text_of(std::string(1'000'000, '(')), SyntaxError);
}

TEST(FormulaParse, AnyNesting) {
    constexpr std::size_t kDeep = (kMostCharacters - 1) / 2;
    EXPECT_EQ(text_of(repeated("(", kDeep) + "x" + repeated(")", kDeep)), "x");
    EXPECT_THROW(text_of(repeated("(", kMostCharacters)), SyntaxError);
    EXPECT_EQ(text_of(repeated("-", kMostCharacters - 1) + "x"), "-x");
    EXPECT_THROW(text_of(repeated("|", kMostCharacters)), SyntaxError);

    struct Around {
        std::string_view open, close;
    };
    for (const Around& around : std::initializer_list<Around>{{"sin(", ")"},
                                                              {"sin ", ""},
                                                              {"x^(", ")"},
                                                              {"x^", ""},
                                                              {"(x+", ")^2"},
                                                              {"x/(1+", ")"},
                                                              {"x-(y*", ")"},
                                                              {"min(x,", ")"},
                                                              {"√", ""},
                                                              {"(", "^z)"}}) {
        const auto nested = [&](std::size_t characters) {
            const std::size_t n = characters / (around.open.size() + around.close.size());
            return repeated(around.open, n) + "y" + repeated(around.close, n);
        };
        text_of(nested(kMostCharacters - 20));
        const Formula f = read(nested(3'000));
        Graph again;
        if (const std::string text = to_text(f.graph, f.f); text.size() <= kMostCharacters) {
            EXPECT_EQ(parse(again, text), copy(again, f.graph, f.f)) << around.open;
        }
        for (const Id g : f.gradient) EXPECT_LE(pieces(f.graph, g).size(), kMostPieces + 2);
    }
}

}  // namespace
}  // namespace normalscope::formulas
