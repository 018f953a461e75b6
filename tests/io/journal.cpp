// What a journal gives back is what was appended, up to the first record that is not whole.
#include "io/journal.hpp"

#include "support/files.hpp"
#include "support/random.hpp"

#include <catch2/catch.hpp>

namespace winnow {

namespace {

using Records = std::vector<std::vector<std::byte>>;

Records read(const std::string& path) {
  Journal journal(path);
  Records records;
  for (std::vector<std::byte> record; journal.next(record);) records.push_back(record);
  return records;
}

Records random_records(test::Random& random, std::size_t count) {
  Records records(count);
  for (auto& record : records) {
    record.resize(random.below(40));
    for (std::byte& byte : record) byte = static_cast<std::byte>(random.below(256));
  }
  return records;
}

void write(const std::string& path, const Records& records) {
  Journal journal(path);
  for (const auto& record : records) journal.append({record});
}

// So many of them, and no other.
bool begins_with(const Records& all, const Records& some) {
  return some.size() <= all.size() && std::equal(some.begin(), some.end(), all.begin());
}

}  // namespace

TEST_CASE("a journal cut anywhere gives the records before") {
  const test::Directory directory;
  const std::string path = directory.file("journal");
  test::Random random(3);
  const Records records = random_records(random, 5);
  write(path, records);
  REQUIRE(read(path) == records);
  const std::string bytes = test::bytes_of_file(path);
  std::size_t most = 0;
  for (std::size_t cut = 0; cut <= bytes.size(); ++cut) {
    test::write_file(path, bytes.substr(0, cut));
    const Records found = read(path);
    CAPTURE(cut);
    REQUIRE(begins_with(records, found));
    REQUIRE(found.size() >= most);
    most = found.size();
    // What is appended then stands behind them.
    Journal journal(path);
    for (std::vector<std::byte> record; journal.next(record);) {
    }
    journal.append({records.back()});
    Records want = found;
    want.push_back(records.back());
    REQUIRE(read(path) == want);
  }
  CHECK(most == records.size());
}

TEST_CASE("a changed bit of a journal ends it") {
  const test::Directory directory;
  const std::string path = directory.file("journal");
  test::Random random(4);
  const Records records = random_records(random, 5);
  write(path, records);
  const std::string bytes = test::bytes_of_file(path);
  for (std::size_t bit = 0; bit < 8 * bytes.size(); bit += 1 + random.below(8)) {
    std::string changed = bytes;
    changed[bit / 8] = static_cast<char>(changed[bit / 8] ^ 1 << bit % 8);
    test::write_file(path, changed);
    const Records found = read(path);
    CAPTURE(bit);
    REQUIRE(found.size() < records.size());
    REQUIRE(begins_with(records, found));
  }
}

TEST_CASE("parts become one record") {
  const test::Directory directory;
  test::Random random(5);
  std::vector<std::byte> head(64, std::byte{7});
  std::vector<std::byte> rest(13, std::byte{9});
  {
    Journal journal(directory.file("journal"));
    journal.append({head, rest});
  }
  std::vector<std::byte> whole = head;
  whole.insert(whole.end(), rest.begin(), rest.end());
  CHECK(read(directory.file("journal")) == Records{whole});
}

}  // namespace winnow
