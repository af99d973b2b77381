#include "verify/check/manifest.hpp"

#include <algorithm>
#include <fstream>
#include <set>

namespace check {

namespace {

struct Entry {
  std::string file;
  std::string checksum;
};

struct Manifest {
  std::vector<FamilyCounts> families;
  std::vector<Entry> entries;
};

// Calls read(lines) for a file of the folder. Puts the file's name before what it throws, and for Rejected the line.
template <class Read>
void read_file(const std::string& folder, const std::string& file, Read&& read) {
  std::ifstream in(folder + "/" + file);
  if (!in) throw Unreadable(folder + "/" + file + " cannot be read");
  Lines lines(in);
  try {
    read(lines);
  } catch (const Rejected& rejected) {
    throw Rejected(file + ":" + std::to_string(lines.number()) + ": " + rejected.what());
  } catch (const Undecided& undecided) {
    throw Undecided(file + ": " + undecided.what());
  }
}

FamilyCounts read_family(const std::vector<std::string_view>& words) {
  const auto family =
      std::find_if(families().begin(), families().end(), [&](const Family& f) { return words[1] == f.name; });
  require(family != families().end(), "there is no such family");
  require(words[2] == family->size, "the sizes of this family are others");
  const std::size_t dots = words[3].find("..");
  require(dots != std::string_view::npos, "a range is not of the form A..B");
  FamilyCounts result{&*family, number(words[3].substr(0, dots)), number(words[3].substr(dots + 2)), 0, {}};
  require(result.first > 0, "a range starts with 0");
  if (result.last > family->most)
    throw Undecided(std::string(family->name) + " beyond " + std::to_string(family->most) + " are not checked");
  return result;
}

Manifest read_manifest(Lines& lines) {
  Manifest manifest;
  const auto& title = lines.next("requad", 3);
  require(title[1] == "manifest" && title[2] == "2", "not a manifest of version 2");
  const std::vector<std::string_view>* words = &lines.next("", 0);
  for (; (*words)[0] == "family"; words = &lines.next("", 0)) {
    require(words->size() == 4, "a line has a wrong number of words");
    manifest.families.push_back(read_family(*words));
    const auto count = manifest.families.size();
    require(count == 1 || manifest.families[count - 2].family < manifest.families[count - 1].family,
            "the families are not in their order, each once");
  }
  require((*words)[0] == "certificates" && words->size() == 2, "expected 'certificates' and their number");
  for (int left = number((*words)[1]); left > 0; --left) {
    const auto& entry = lines.next("", 2);
    manifest.entries.push_back({std::string(entry[0]), std::string(entry[1])});
  }
  lines.next("end", 1);
  lines.finish();
  return manifest;
}

std::string file_of(const Region& region) { return region.name() + ".txt"; }

// Calls visit(counts, region) for each region of the manifest.
template <class Visit>
void for_each_region(Manifest& manifest, Visit&& visit) {
  for (FamilyCounts& f : manifest.families) {
    for_each_region(*f.family, f.first, f.last, [&](const Region& region) { visit(f, region); });
  }
}

// Requires that the files are those of all regions for which the closed form is not 0.
void require_whole(Manifest& manifest) {
  std::vector<std::string> files;
  for_each_region(manifest, [&](const FamilyCounts&, const Region& region) {
    if (closed_form(region) > 0) files.push_back(file_of(region));
  });
  const std::set<std::string> expected(files.begin(), files.end());
  std::set<std::string> listed;
  for (const Entry& entry : manifest.entries) {
    if (expected.count(entry.file) == 0) throw Rejected(entry.file.substr(0, 60) + " is no region of the families");
    if (!listed.insert(entry.file).second) throw Rejected(entry.file + " is listed twice");
  }
  for (const std::string& file : files) {
    if (listed.count(file) == 0) throw Rejected(file + " is missing");
  }
  for (std::size_t i = 0; i < files.size(); ++i)
    require(files[i] == manifest.entries[i].file, "the files are not in order");
}

}  // namespace

std::vector<FamilyCounts> check_folder(const std::string& folder) {
  Manifest manifest;
  read_file(folder, "MANIFEST", [&](Lines& lines) {
    manifest = read_manifest(lines);
    require_whole(manifest);
  });
  if (manifest.entries.empty()) throw Undecided(folder + "/MANIFEST lists no certificate");
  FillingCounter counter;
  auto entry = manifest.entries.begin();
  for_each_region(manifest, [&](FamilyCounts& family, const Region& region) {
    if (closed_form(region) == 0) {
      ++family.empty;
      if (counter.with_pair(region) != 0)
        throw Rejected("MANIFEST: " + file_of(region) +
                       " is missing: the region has fillings, but the closed form is 0");
      return;
    }
    const std::string checksum = (entry++)->checksum;
    read_file(folder, file_of(region), [&](Lines& lines) {
      const Counts counts = check_certificate(lines, &region, counter);
      require(lines.checksum() == checksum, "the file's checksum is not the one in the MANIFEST");
      family.counts.regions += counts.regions;
      family.counts.configurations += counts.configurations;
      family.counts.merged += counts.merged;
      family.counts.edges += counts.edges;
    });
  });
  return manifest.families;
}

}  // namespace check
