// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Where the sensor list of a data file comes from.

#include "tests/unit/slocum/data_bench.h"

#include <algorithm>

namespace glider::slocum {
namespace {

second::Draft factoredDraft() {
  second::Draft draft = smallDraft();
  draft.factored = true;
  return draft;
}

std::string upperCase(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::toupper(c); });
  return text;
}

TEST(SensorLists, AreFoundBesideTheFile) {
  const std::string list = listText(factoredDraft()), crc = second::crcOf(list);
  const std::vector<std::pair<std::string, std::string>> places = {
      {crc + ".cac", list},
      {"cac/" + crc + ".cac", list},
      {"cache/" + upperCase(crc) + ".CAC", list},
      {crc + ".ccc", second::pack(list, 100)},
  };
  for (const auto& [place, content] : places) {
    const TestFolder folder;
    const auto path = folder.write("a.sbd", write(factoredDraft()));
    folder.write(place, content);
    SensorLists lists;
    const auto file = readDataFile(path, lists);
    ASSERT_TRUE(file) << place << ": " << file.error().message;  // accepts: GL5201 GL5202
    EXPECT_EQ(difference(cellsOf(*file), smallDraft().rows), "");
  }
}

TEST(SensorLists, AMissingOneIsNamedWithThePlacesSearched) {
  const TestFolder folder;
  const auto path = folder.write("a.sbd", write(factoredDraft()));
  const std::string crc = second::crcOf(listText(factoredDraft()));
  SensorLists lists;
  const auto file = readDataFile(path, lists);
  ASSERT_FALSE(file);
  EXPECT_EQ(support::code(file.error().id), "GL5201");
  for (const std::string& part : {path.string(), crc + ".cac", (folder.path() / "cac").string(),
                                  (folder.path() / "cache").string()}) {
    EXPECT_NE(file.error().message.find("`" + part + "`"), std::string::npos) << part;
  }
}

TEST(SensorLists, FoldersThatAreNamedReplaceThoseBesideTheFile) {
  const TestFolder folder;
  const auto path = folder.write("a.sbd", write(factoredDraft()));
  const std::string list = listText(factoredDraft()), name = second::crcOf(list) + ".cac";
  folder.write(name, list);
  SensorLists elsewhere({folder.path() / "other"});
  const auto missing = readDataFile(path, elsewhere);
  ASSERT_FALSE(missing);
  EXPECT_EQ(support::code(missing.error().id), "GL5201");
  folder.write("other/" + name, list);
  SensorLists there({folder.path() / "none", folder.path() / "other"});
  EXPECT_TRUE(readDataFile(path, there));
}

TEST(SensorLists, ComeFromEarlierFiles) {
  SensorLists lists({"no_such_folder"});
  ASSERT_TRUE(decodeDataFile("a.sbd", write(smallDraft()), lists));
  EXPECT_TRUE(decodeDataFile("b.sbd", write(factoredDraft()), lists));
}

TEST(SensorLists, AnInvalidOneIsNotUsed) {
  const std::string list = listText(factoredDraft()), crc = second::crcOf(list);
  std::string other = list;
  other.replace(other.find("m_depth"), 7, "m_dexth");
  for (const std::string& content : {other, list.substr(0, list.size() - 1), std::string("hello\n"),
                                     list + list, std::string()}) {
    const TestFolder folder;
    const auto path = folder.write("a.sbd", write(factoredDraft()));
    const auto bad = folder.write(crc + ".cac", content);
    SensorLists lists;
    const auto file = readDataFile(path, lists);
    ASSERT_FALSE(file);
    EXPECT_EQ(support::code(file.error().id), "GL5202") << file.error().message;
    EXPECT_NE(file.error().message.find(bad.string()), std::string::npos) << file.error().message;
    folder.write("cache/" + crc + ".cac", list);
    SensorLists again;
    EXPECT_TRUE(readDataFile(path, again)) << "a valid one elsewhere is used";
  }
}

TEST(DataFolder, HasTheDataFilesByName) {
  const TestFolder folder;
  for (const char* name :
       {"b.sbd", "a.TCD", "c.mbd", "d.ecd", "notes.txt", "x.cac", "y.bd", "z.abd"}) {
    folder.write(name, "");
  }
  const auto found = findDataFiles(folder.path());
  ASSERT_TRUE(found);
  std::string names;
  for (const auto& path : *found) {
    names += path.filename().string() + " ";
  }
  EXPECT_EQ(names, "a.TCD b.sbd c.mbd d.ecd ");
  folder.write("empty/readme", "");
  const auto none = findDataFiles(folder.path() / "empty");
  ASSERT_FALSE(none);
  EXPECT_EQ(support::code(none.error().id), "GL9001");
}

}  // namespace
}  // namespace glider::slocum
