#pragma once

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

/// Removes what writeWeldFiles() and writeReport() leave: beside another scan they would be taken for its own.
void removeWeldFiles(const std::string& directory);

/// The parameters as YAML, one a line.
std::string settingsText(const WeldSettings& settings);

/// Calls the report program for a folder that writeWeldFiles() has filled.
/// @return report.html and report.png. @throws InputError with what the program said.
std::vector<std::string> writeReport(const std::string& directory);

/// The same for a comparison before and after grinding: a folder with compare.json and difference.pcd.
/// @param named  the folder's name in the report: where the files will lie.
std::vector<std::string> writeCompareReport(const std::string& directory, const std::string& named);
}  // namespace weld_profiler
