// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

// A fuzzer without libFuzzer, for every compiler: runs the files of its corpus, then what chance makes of them.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <random>

#include "common/command_line.hpp"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size);

namespace {

using Input = std::vector<uint8_t>;

//! Inputs grow no longer than this, bytes.
constexpr size_t kLongest = 1 << 14;

Input contentOf(const std::string& path)
{
    std::ifstream stream(path, std::ios::binary);
    if (!stream.is_open() || std::filesystem::is_directory(path))
        throw std::runtime_error(path + ": cannot be opened");
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

//! All files, in folders too, by name.
std::vector<Input> readAll(const std::vector<std::string>& paths)
{
    std::vector<std::string> files;
    for (const std::string& path : paths) {
        if (!std::filesystem::is_directory(path))
            files.push_back(path);
        else
            for (const auto& entry : std::filesystem::directory_iterator(path))
                files.push_back(entry.path().string());
    }
    std::sort(files.begin(), files.end());
    std::vector<Input> inputs;
    for (const std::string& file : files)
        inputs.push_back(contentOf(file));
    return inputs;
}

/** Changes inputs by chance. The engine is the same everywhere, the distributions of the standard library are not. */
class Mutator
{
public:
    Mutator(unsigned seed, const std::vector<Input>& corpus) : random_(seed), corpus_(corpus) {}

    Input next()
    {
        Input input = corpus_[below(corpus_.size())];
        if (input.size() > kLongest)
            input.resize(kLongest);
        for (size_t change = 0, changes = 1 + below(8); change < changes; ++change)
            mutate(input);
        return input;
    }

private:
    std::mt19937 random_;
    const std::vector<Input>& corpus_;

    size_t below(size_t count) { return random_() % count; }

    uint8_t byte()
    {
        const uint8_t special[] = {0x00, 0xff, 0x7f, 0x80, '-', '9', ' ', '\n'};
        return below(4) == 0 ? special[below(8)] : static_cast<uint8_t>(below(256));
    }

    //! Words that a reader of numbers may stumble over.
    void insertWord(Input& input, size_t at)
    {
        const char* const words[] = {"nan", "inf", "1e999", "-1e308", "99999999999999999999",
                                     "0",   "-1",  "#",     "\"",     ":"};
        const std::string word = words[below(std::size(words))];
        input.insert(input.begin() + static_cast<std::ptrdiff_t>(at), word.begin(), word.end());
    }

    void mutate(Input& input)
    {
        const auto begin = [&] { return input.begin(); };
        const size_t at = below(input.size() + 1);
        const auto first = static_cast<std::ptrdiff_t>(at);
        const size_t count = std::min(1 + below(below(8) == 0 ? 256 : 8), input.size() - at);
        const auto last = static_cast<std::ptrdiff_t>(at + count);
        switch (below(7)) {
            case 0:
                input.resize(at);
                break;
            case 1:
                input.erase(begin() + first, begin() + last);
                break;
            case 2: {
                const Input part(begin() + first, begin() + last);
                input.insert(begin() + static_cast<std::ptrdiff_t>(below(input.size() + 1)), part.begin(), part.end());
                break;
            }
            case 3: {
                const Input& other = corpus_[below(corpus_.size())];
                input.resize(at);
                input.insert(input.end(), other.begin() + static_cast<std::ptrdiff_t>(below(other.size() + 1)),
                             other.end());
                break;
            }
            case 4:
                insertWord(input, at);
                break;
            case 5:
                input.insert(begin() + first, byte());
                break;
            default:
                std::generate(begin() + first, begin() + last, [this] { return byte(); });
        }
        input.resize(std::min(input.size(), kLongest));
    }
};

int run(const samples::Arguments& arguments)
{
    const std::vector<Input> corpus = readAll(arguments.files);
    const std::string save = arguments.options.get<std::string>("save");
    const auto runOne = [&](const Input& input) {
        if (!save.empty())
            std::ofstream(save, std::ios::binary)
                .write(reinterpret_cast<const char*>(input.data()), static_cast<std::streamsize>(input.size()));
        LLVMFuzzerTestOneInput(input.data(), input.size());
    };
    if (corpus.empty())
        throw std::runtime_error("no inputs to start from");
    std::for_each(corpus.begin(), corpus.end(), runOne);
    Mutator mutator(arguments.get<unsigned>("seed"), corpus);
    const int runs = arguments.get<int>("runs");
    for (int i = 0; i < runs; ++i)
        runOne(mutator.next());
    std::cout << corpus.size() << " files and " << runs << " inputs made of them" << std::endl;
    return 0;
}

}  // namespace

int main(int argc, char** argv)
{
    return samples::runProgram(argc, argv,
                               "{help h | | this text}"
                               "{runs | 0 | inputs to make of the files}"
                               "{seed | 1 | of the random numbers that make them}"
                               "{save | | file that each input is written to before it runs: the last is the one that "
                               "ended the program}",
                               "fuzz_<name> [options] <file or folder>...", 1, run);
}
