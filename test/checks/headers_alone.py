#!/usr/bin/python3
"""Compiles each public header by itself as C++17: it must bring what it needs.

usage: headers_alone.py ROOT COMPILER INCLUDE_DIRECTORY...
"""
import concurrent.futures
import os
import subprocess
import sys

from source_tree import Tree, finish


def compile_alone(compiler, directories, header):
    """What the compiler said; empty = fine. Included twice, for the guard."""
    name = header[len("include/"):]
    command = [compiler, "-std=c++17", "-pedantic", "-Wall", "-Wextra", "-Werror", "-fsyntax-only", "-x", "c++", "-"]
    command += [part for directory in directories for part in ("-isystem", directory)]
    command[1:1] = ["-I", "include"]
    source = '#include "%s"\n#include "%s"\n' % (name, name)
    run = subprocess.run(command, input=source, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True)
    return "" if run.returncode == 0 else "%s does not compile alone:\n%s" % (header, run.stdout)


def main(root, compiler, directories):
    tree = Tree(root)
    # -isystem /usr/include would hide the standard library from itself
    directories = [name for name in directories if name and os.path.realpath(name) != "/usr/include"]
    headers = tree.files(["include/weld_profiler"], [".h"])
    os.chdir(tree.root)
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        answers = list(pool.map(lambda header: compile_alone(compiler, directories, header), headers))
    return finish("headers alone", [answer for answer in answers if answer], len(headers), 15)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2], sys.argv[3:]))
