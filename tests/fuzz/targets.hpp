// What is fuzzed, and what its corpus is replayed with: one body for both. A target takes any
// bytes; it returns where they were handled as they should be, Error among that, and ends the
// program otherwise.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace winnow::fuzz {

struct Target {
  const char* name;  // also of its folder in corpus/
  void (*run)(std::span<const std::byte> bytes);
};

// A new one is a function in a file of its own, a line in targets.cpp and a folder of small files.
const std::vector<Target>& targets();
const Target& target_called(const std::string& name);

// Ends the program, saying what does not hold.
void expect(bool holds, const char* what);

void read_mesh(std::span<const std::byte> bytes);  // every format that the content can be taken for
void read_spill(std::span<const std::byte> bytes);     // blocks in scratch that a disk has changed
void read_journal(std::span<const std::byte> bytes);   // what a checkpoint holds of a round
void read_manifest(std::span<const std::byte> bytes);  // ... and of a run
void decimate(std::span<const std::byte> bytes);       // faces that make no surface
void play(std::span<const std::byte> bytes);           // a progressive file, up and down

}  // namespace winnow::fuzz
