#!/usr/bin/python3
"""Finds what Ubuntu 20.04 (gcc 9, OpenCV 4.2, PCL 1.10, Eigen 3.3, yaml-cpp 0.6, CMake 3.16, Python 3.8) does not have.

No list is complete: this one holds what came after and is likely to be reached for.
"""
import re
import sys

from source_tree import CPP, Tree, finish

CPP_NEWER = (
    # OpenCV after 4.2
    (r"\bcv::(stackBlur|haveImageReader|haveImageWriter|imcount|approxPolyN|transposeND|broadcast|flipND|hasNonZero|"
     r"reduceArgMax|reduceArgMin|finiteMask|imencodemulti|imdecodemulti|blendLinear2|SIFT|ImageCollection)\b", "OpenCV"),
    (r"\b(COLORMAP_TURBO|COLORMAP_DEEPGREEN|IMREAD_COLOR_RGB|INTER_NEAREST_EXACT|THRESH_DRYRUN|IMWRITE_PNG_FILTER|"
     r"COLOR_Bayer(RG|GR|BG|GB)G2\w+|COLOR_Bayer(RGGB|GRBG|BGGR|GBRG)2\w+)\b", "OpenCV"),
    # PCL after 1.10: there, a cloud's Ptr is a boost::shared_ptr; from 1.11 on a std::shared_ptr. Write Ptr.
    (r"pcl/(memory|types|type_traits)\.h", "PCL"),
    (r"\bpcl::(shared_ptr|dynamic_pointer_cast|static_pointer_cast|Indices\b|index_t|uindex_t|experimental|FunctionFilter)",
     "PCL"),
    (r"\b(boost|std)::(shared_ptr|make_shared)<\s*(const\s+)?pcl::", "PCL (write Cloud::Ptr)"),
    (r"\.transient_(push|emplace)_back\b", "PCL"),
    # Eigen after 3.3
    (r"\bEigen::(seq|seqN|all|last|lastN|lastp1|placeholders|indexing|fix)\b", "Eigen"),
    (r"\bEigen::(Row)?Vector(2|3|4|X)?<", "Eigen"),
    (r"\bEigen::Matrix(2|3|4|X)<", "Eigen"),
    (r"\.reshaped(<|\()", "Eigen"),
    # C++ after 17, or in the standard but not in gcc 9's library
    (r"#\s*include\s*<(span|concepts|ranges|format|numbers|bit|compare|coroutine|semaphore|latch|barrier|stop_token|"
     r"source_location|syncstream|expected|print|mdspan)>", "C++17"),
    (r"\bstd::(span|numbers|bit_cast|jthread|ssize|lerp|midpoint|erase_if|to_array|ranges|format)\b", "C++17"),
    (r"\.(starts_with|ends_with)\s*\(", "C++17"),
    (r"\b(consteval|constinit|co_await|co_yield)\b|\brequires\s*\(", "C++17"),
    (r"\[\[(likely|unlikely|no_unique_address)\]\]", "C++17"),
    (r"\bstd::(from_chars|to_chars)\b", "gcc 9 (it has them for whole numbers only)"),
    (r"#\s*include\s*<execution>", "gcc 9 without TBB"),
    (r"#\s*include\s*<pluginlib/\w+\.h>", "Debian 12 (pluginlib has .hpp only)"),
)
CMAKE_NEWER = (
    (r"(?i)\b(cmake_path|cmake_language|block)\s*\(", "CMake 3.16"),
    (r"(?i)\bfile\s*\(\s*(REAL_PATH|CONFIGURE|ARCHIVE_\w+|CHMOD|COPY_FILE)\b", "CMake 3.16"),
    (r"(?i)\bstring\s*\(\s*JSON\b", "CMake 3.16"),
    (r"(?i)\bZIP_LISTS\b", "CMake 3.16"),
    (r"(?i)cmake_minimum_required\s*\(\s*VERSION\s+(3\.(1[7-9]|[2-9]\d)|[4-9])", "CMake 3.16"),
    (r"-march=native", "a machine other than the one it was built on"),
)
PYTHON_NEWER = (
    (r"\.(removeprefix|removesuffix)\(", "Python 3.8"),
    (r"^\s*match\s+[^=]+:\s*$", "Python 3.8"),
    (r"^\s*(import|from)\s+(zoneinfo|tomllib|graphlib)\b", "Python 3.8"),
    (r"\bint\.bit_count\b|\bitertools\.pairwise\b|\bmath\.lcm\b", "Python 3.8"),
)


def findings_of(tree, path, patterns):
    found = []
    for number, line in tree.lines(path):
        code = re.sub(r"//.*$", "", line)
        for pattern, library in patterns:
            match = re.search(pattern, code)
            if match:
                found.append("%s:%d: '%s' is not in %s" % (path, number, match.group(0).strip(), library))
    return found


def main(root):
    tree = Tree(root)
    cpp = tree.files(["src", "include", "test", "benchmark"], CPP)
    cmake = ["CMakeLists.txt"] + tree.files(["src", "test", "benchmark"], ["CMakeLists.txt", ".cmake"])
    python = [path for path in tree.files(["scripts", "test", "cfg"], [".py", ".cfg"]) if "old_interfaces" not in path]
    python = [path for path in python if not path.endswith("checks_fail_test.py")]
    findings = []
    for paths, patterns in ((cpp, CPP_NEWER), (cmake, CMAKE_NEWER), (python, PYTHON_NEWER)):
        for path in paths:
            findings += findings_of(tree, path, patterns)
    return finish("old interfaces", findings, len(cpp) + len(cmake) + len(python), 30)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
