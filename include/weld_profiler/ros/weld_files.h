#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "weld_profiler/core/scan.h"
#include "weld_profiler/weld/weld_evaluation.h"

namespace weld_profiler
{
/// Which calibration a scan was made with.
struct CalibrationRecord
{
  std::string file;  ///< file or URL; empty = not known
  std::string hash;  ///< checksum of the file's bytes, 16 hexadecimal digits
  std::string date;  ///< as the file says (ISO 8601); empty = it does not
};

/// Reads file, checksum (FNV-1a, 64 bit: it tells files apart, it guards nothing) and the optional `date`.
/// @throws InputError when the file cannot be read.
CalibrationRecord calibrationRecord(const std::string& path);

/// What stands beside the numbers.
struct WeldRecordInfo
{
  std::string weld_id;  ///< may be empty
  CalibrationRecord calibration;
};

/// Writes what docs/weld-files.md lists, but for the scan itself and the report, into a folder that exists. Each file
/// appears whole or not at all; those of an earlier run, its report too, are removed before.
/// @return their paths, in the order of that page.
/// @throws InputError naming path and cause.
std::vector<std::string> writeWeldFiles(const Scan& scan, const WeldEvaluation& evaluation,
                                        const WeldSettings& settings, const WeldRecordInfo& info,
                                        const std::string& directory);

/// What of the scan itself lies in a folder already and is not to be removed.
struct FreshFiles
{
  std::size_t scans = 0;  ///< scan.pcd, scan_2.pcd, ... and the folders scan_2, ...: so many
  bool summary = false;   ///< summary.json
};

/// Removes from a folder what an earlier run left: clouds, summary.json, the folders of further welds, and all that
/// writeWeldFiles() and writeReport() leave, there and in the folders that stay. Beside a new scan it would be taken
/// for that scan's. Files of other names and links stay; so do clouds where neither an earlier
/// summary.json lies nor a fresh one: those were saved by hand.
/// @throws std::filesystem::filesystem_error when a cloud or folder cannot be removed.
void removeStaleFiles(const std::string& directory, const FreshFiles& fresh);

/// The parameters as YAML, one a line.
std::string settingsText(const WeldSettings& settings);

/// Calls the report program for a folder that writeWeldFiles() has filled.
/// @return report.html and report.png. @throws InputError with what the program said.
std::vector<std::string> writeReport(const std::string& directory);

/// The same for a comparison before and after grinding: a folder with compare.json and difference.pcd.
/// @param named  the folder's name in the report: where the files will lie.
std::vector<std::string> writeCompareReport(const std::string& directory, const std::string& named);
}  // namespace weld_profiler
