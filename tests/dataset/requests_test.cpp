// SPDX-License-Identifier: Apache-2.0
// REQUESTs as Adams/View writes them: names in quotes, lists over several lines, components left out. And the
// statements that no motion depends on.
#include <iterator>
#include <random>

#include "base/format.h"
#include "dataset/reading.h"

namespace jprim {
namespace {

using Names = std::vector<std::string>;

RequestStatement readRequest(const std::string& text) {
    const Dataset dataset = readGood(text);
    EXPECT_EQ(dataset.requests.size(), 1u) << text;
    return dataset.requests.at(0);
}

TEST(DatasetRequests, NamesAndUnitsBeforeTheFunctions) {
    const RequestStatement r = readRequest(
        "REQUEST/1\n, CUNITS = \"no_units\", \"angle\", \"angular_velocity\"\n, CNAMES = \"\", \"swing\", \"rate\"\n"
        ", RESULTS_NAME = arm\n, F2 = AZ(2,1)\\\n, F3 = WZ(2,1)\\");
    EXPECT_EQ(r.cunits, (Names{"no_units", "angle", "angular_velocity"}));
    EXPECT_EQ(r.cnames, (Names{"", "swing", "rate"}));
    EXPECT_EQ(r.resultsName, "arm");
    ASSERT_EQ(r.expressions.size(), 2u);
    EXPECT_EQ(r.expressions[1].first, 3);
    EXPECT_EQ(r.expressions[1].second.text, "WZ(2,1)");
}

TEST(DatasetRequests, MarksInQuotesMeanNothing) {
    const RequestStatement r = readRequest(
        "REQUEST/1, CNAMES=\"a, b\", \"c!d\", \"e&f\", \"g;h\", \"F2=i\", \" j \", \"it's\", \"\\\" ! \"QQQ\"\n"
        ", CLABELS=\"&\", \"!\" &\n, \",\", CTITLE=\"x;\",\n\"y\", RESULTS_NAME=\"k, l\", COMMENT=\"m, n!\", F2=TIME");
    EXPECT_EQ(r.cnames, (Names{"a, b", "c!d", "e&f", "g;h", "F2=i", " j ", "it's", "\\"}));
    EXPECT_EQ(r.clabels, (Names{"&", "!", ","}));
    EXPECT_EQ(r.ctitle, (Names{"x;", "y"}));
    EXPECT_EQ(r.resultsName, "k, l");
    EXPECT_EQ(r.comment, "\"m, n!\"");
}

// Quotes elsewhere are characters like any other.
TEST(DatasetRequests, OnlyWhatBeginsAnItemIsAQuote) {
    const RequestStatement r =
        readRequest("REQUEST/1, C=6\" rod ! of \"QQQ\"\n, CNAMES=12\", 6\"x\" y, F2=TIME");
    EXPECT_EQ(r.comment, "6\" rod");
    EXPECT_EQ(r.cnames, (Names{"12\"", "6\"x\" y"}));
}

TEST(DatasetRequests, NamesWithoutQuotes) {
    EXPECT_EQ(readRequest("REQUEST/1, D, I=1, CNAMES=MG, x , , v, force, J=2").cnames,
              (Names{"MG", "x", "", "v", "force"}));
    EXPECT_EQ(readRequest("REQUEST/1, CNAMES=, d, F2=1").cnames, (Names{"", "d"}));
    const RequestStatement r = readRequest("REQUEST/1, CUNITS=a, velocity unit, VELOCITY, I=1");
    EXPECT_EQ(r.cunits, (Names{"a", "velocity unit"}));
    EXPECT_EQ(r.type, RequestType::Velocity);
    EXPECT_TRUE(readRequest("REQUEST/1, RESULTS_NAME=\"\", F2=1").resultsName.empty());
}

TEST(DatasetRequests, EveryComponentMayBeThereOrNot) {
    for (int mask = 1; mask < 256; ++mask) {
        std::string text = "REQUEST/1";
        for (int k = 0; k < 8; ++k)
            if (mask >> k & 1) text += fmt::format(", F{}={}*TIME\\", k + 1, k + 11);
        const RequestStatement r = readRequest(text);
        std::size_t next = 0;
        for (int k = 0; k < 8; ++k) {
            if (!(mask >> k & 1)) continue;
            ASSERT_LT(next, r.expressions.size()) << text;
            EXPECT_EQ(r.expressions[next].first, k + 1);
            EXPECT_EQ(r.expressions[next++].second.text, fmt::format("{}*TIME", k + 11));
        }
        EXPECT_EQ(next, r.expressions.size());
    }
}

/// Requests with any names, and texts that say the same in any layout.
class RandomRequests {
public:
    RequestStatement make() {
        RequestStatement r;
        r.id = 1 + choose(999);
        for (Names* list : {&r.cnames, &r.cunits, &r.clabels, &r.ctitle})
            for (int k = choose(9); k > 0; --k) list->push_back(makeName());
        r.resultsName = makeName();
        if (choose(2) == 0) {
            r.type = static_cast<RequestType>(choose(4));
            r.i = 1;
            r.j = choose(3);
            return r;
        }
        r.type = RequestType::Expressions;
        const char* const functions[] = {"AZ(2,1)", "2*DX(2,1,1) + 3", "TIME", "MAX(VM(2), 1) - 5"};
        for (int k = 1; k <= 8; ++k)
            if (choose(2) == 0 || (k == 8 && r.expressions.empty()))
                r.expressions.push_back({k, {functions[choose(4)], {}}});
        return r;
    }

    std::string write(const RequestStatement& r) {
        std::vector<std::string> arguments;
        const auto addNames = [&](const char* keyword, const Names& names) {
            if (!names.empty()) arguments.push_back(std::string(keyword) + gap() + "=" + gap() + join(names));
        };
        addNames("CUNITS", r.cunits);
        addNames("CNAMES", r.cnames);
        addNames("CLABELS", r.clabels);
        addNames("CTITLE", r.ctitle);
        if (!r.resultsName.empty()) addNames("RESULTS_NAME", {r.resultsName});
        if (r.type != RequestType::Expressions)
            arguments.push_back(fmt::format("{}, I={}, J={}", getAdamsName(r.type), r.i, r.j));
        for (const auto& [k, function] : r.expressions)
            arguments.push_back(fmt::format("F{}={}", k, breakUp(function.text)));
        // Functions keep their order, everything else may stand anywhere among them.
        for (std::size_t k = 0; k + 1 < arguments.size() - r.expressions.size(); ++k)
            std::swap(arguments[k], arguments[k + std::size_t(choose(2))]);
        std::string text = fmt::format("REQUEST/{}", r.id);
        for (std::size_t k = 0; k < arguments.size(); ++k) {
            const bool behindFunction = k > 0 && arguments[k - 1][0] == 'F' && arguments[k - 1][2] == '=';
            text += behindFunction && choose(2) == 0 ? (choose(2) == 0 ? "\\" : "\\\n, ") : separate();
            text += arguments[k];
        }
        return text;
    }

    int choose(int count) { return int(m_random() % unsigned(count)); }

private:
    std::string makeName() {
        const std::string letters = "abXYZ_019 ,;!&='/\\()[]:%.$\t\xe4";
        std::string name;
        for (int k = choose(3) == 0 ? 0 : choose(12); k > 0; --k)
            name += letters[std::size_t(choose(int(letters.size())))];
        return name;
    }

    std::string gap() { return std::string(std::size_t(choose(3)), ' '); }

    // All the ways in which a list goes on.
    std::string separate() {
        const char* const ways[] = {",",      ", ",     " , ",    ",\n",         "\n,",
                                    "\n  , ", " &\n, ", ",\n , ", ", ! \"a, \n", " ! b\", c\n! d\n, ",
                                    "\r\n, ", ", &\n",  "\n\n,\t"};
        return ways[choose(int(std::size(ways)))];
    }

    std::string join(const Names& names) {
        std::string text;
        for (std::size_t k = 0; k < names.size(); ++k)
            text += (k == 0 ? "" : separate()) + "\"" + names[k] + "\"";
        return text;
    }

    // A function may be broken where it has a blank.
    std::string breakUp(const std::string& function) {
        std::string text;
        for (const char c : function) text += c == ' ' && choose(2) == 0 ? "\n, " : std::string(1, c);
        return text;
    }

    std::mt19937 m_random{20250713};
};

TEST(DatasetRequests, AnyNamesInAnyLayout) {
    RandomRequests random;
    Dataset expected = readGood("");
    for (int k = 0; k < 2000; ++k) {
        expected.requests = {random.make()};
        const std::string text = random.write(expected.requests[0]);
        ASSERT_EQ(readGood(text), expected) << text;
    }
}

// Shows that the comparison above can fail: whichever name is changed, something else is read.
TEST(DatasetRequests, EveryNameMatters) {
    RandomRequests random;
    Dataset expected = readGood("");
    int changed = 0;
    for (int k = 0; k < 100; ++k) {
        const RequestStatement request = random.make();
        const Dataset dataset = readGood(random.write(request));
        for (auto list : {&RequestStatement::cnames, &RequestStatement::cunits, &RequestStatement::clabels,
                          &RequestStatement::ctitle})
            for (std::size_t n = 0; n < (request.*list).size(); ++n, ++changed) {
                expected.requests = {request};
                (expected.requests[0].*list)[n] += 'x';
                EXPECT_NE(dataset, expected);
            }
    }
    EXPECT_GT(changed, 500);
}

TEST(DatasetIgnored, MaterialsAreKeptAsText) {
    const Dataset dataset = readGood(
        "MATERIAL/3, NAME = \".rod, steel!\"\n, YOUNGS_MODULUS = 2.07E+11, POISSONS_RATIO=0.29,  DENSITY=7801\nMATE/4");
    ASSERT_EQ(dataset.ignored.size(), 2u);
    EXPECT_EQ(dataset.ignored[0].keyword, "MATERIAL");
    EXPECT_EQ(dataset.ignored[0].arguments,
              "NAME = \".rod, steel!\", YOUNGS_MODULUS = 2.07E+11, POISSONS_RATIO=0.29, DENSITY=7801");
    EXPECT_EQ(dataset.counts.ignored, 2);
}

}  // namespace
}  // namespace jprim
