// SPDX-License-Identifier: Apache-2.0
// What the fuzzer checks, on its seeds and on a fixed number of mutations of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <vector>

#include "dataset/command_properties.h"

namespace jprim {
namespace {

// Sorted, because the order of a folder differs between machines.
std::vector<std::string> readCorpus(const std::string& name) {
    std::vector<std::filesystem::path> paths;
    for (const auto& entry :
         std::filesystem::directory_iterator(JPRIM_SOURCE_DIR "/tests/fuzz/corpus/" + name))
        paths.push_back(entry.path());
    std::sort(paths.begin(), paths.end());
    std::vector<std::string> texts;
    for (const auto& path : paths) {
        std::ostringstream text;
        text << std::ifstream(path, std::ios::binary).rdbuf();
        texts.push_back(text.str());
    }
    return texts;
}

class Mutator {
public:
    explicit Mutator(std::vector<std::string> texts) : m_texts(std::move(texts)) {}

    // A text of the corpus with one to four places changed.
    std::string make() {
        std::string text = m_texts[draw(m_texts.size())];
        for (std::size_t i = draw(4); i < 4; ++i) change(text);
        return text;
    }

private:
    // The remainder and not a distribution: those differ between standard libraries.
    std::size_t draw(std::size_t bound) { return bound == 0 ? 0 : m_random() % bound; }

    void change(std::string& text) {
        const std::string marks = ",&;!\\=/:\n\r\t ()[]-+.0129DdEX\xe4";
        const std::size_t at = draw(text.size());
        const std::string& other = m_texts[draw(m_texts.size())];
        switch (draw(5)) {
            case 0: text.insert(at, 1, marks[draw(marks.size())]); break;
            case 1: text.erase(at, 1 + draw(8)); break;
            case 2: text.insert(at, other.substr(draw(other.size()), 1 + draw(60))); break;
            case 3: text.insert(at, 1, static_cast<char>(draw(256))); break;
            default: text.resize(at);
        }
    }

    std::vector<std::string> m_texts;
    std::mt19937 m_random{20240607};
};

using FindBroken = std::string (*)(std::string_view);

void checkSeeds(const std::string& corpus, FindBroken findBroken) {
    const std::vector<std::string> texts = readCorpus(corpus);
    EXPECT_GE(texts.size(), 3u);
    for (const std::string& text : texts) EXPECT_EQ(findBroken(text), "") << text;
}

void checkMutations(const std::string& corpus, FindBroken findBroken) {
    Mutator mutator(readCorpus(corpus));
    for (int i = 0; i < 20000; ++i) {
        const std::string text = mutator.make();
        ASSERT_EQ(findBroken(text), "") << text;
    }
}

TEST(DatasetFuzz, SeedsKeepTheProperties) {
    checkSeeds("read_dataset", findBrokenProperty);
}

TEST(DatasetFuzz, MutationsKeepTheProperties) {
    checkMutations("read_dataset", findBrokenProperty);
}

TEST(CommandFuzz, SeedsKeepTheProperties) {
    checkSeeds("read_commands", findBrokenCommandProperty);
}

TEST(CommandFuzz, MutationsKeepTheProperties) {
    checkMutations("read_commands", findBrokenCommandProperty);
}

}  // namespace
}  // namespace jprim
