// Every stripe method next to every other, against the truth, the bound and one read of the frame, in one run.
//   stripe_comparison [--quick] [--only clean,systematic,scenes,speckle,notch,repair,times,sizes,SCENE,...]
//                     [--methods a,b,...] [--judge METHOD] [--json FILE]
#include <cstdio>
#include <cstring>
#include <exception>
#include <sstream>

#include "comparison/context.h"
#include "comparison/scenes.h"

namespace
{
using weld_profiler::comparison::Context;
using weld_profiler::comparison::Options;

struct Part
{
  const char* name;
  void (*run)(Context&);
};

const Part kParts[] = {
  { "clean", weld_profiler::comparison::compareClean },
  { "systematic", weld_profiler::comparison::compareSystematic },
  { "scenes", weld_profiler::comparison::compareScenes },
  { "speckle", weld_profiler::comparison::compareSpeckle },
  { "notch", weld_profiler::comparison::compareNotch },
  { "repair", weld_profiler::comparison::compareRepair },
  { "times", weld_profiler::comparison::compareTimes },
  { "sizes", weld_profiler::comparison::compareSizes },
};

std::vector<std::string> split(const char* text)
{
  std::vector<std::string> words;
  std::istringstream stream(text);
  for (std::string word; std::getline(stream, word, ',');)
    words.push_back(word);
  return words;
}

void usage()
{
  std::printf(
      "Every stripe method next to every other, in one run.\n"
      "  --quick  fewer seeds;  --only  parts or scenes;  --methods  contestants;  --json  also writes a file\n"
      "  --judge  the method held against the bars, in place of the default\n"
      "stripe_comparison [--quick] [--only PART,...] [--methods NAME,...] [--judge NAME] [--json FILE]\nparts:");
  for (const Part& part : kParts)
    std::printf(" %s", part.name);
  std::printf("\nscenes, of part `scenes`:");
  for (const std::string& name : weld_profiler::comparison::sceneNames())
    std::printf(" %s", name.c_str());
  std::printf("\nmethods:");
  for (const std::string& name : weld_profiler::comparison::candidateNames())
    std::printf(" %s", name.c_str());
  std::printf("\n");
}

bool read(int argc, char** argv, Options& options)
{
  options.methods = weld_profiler::comparison::candidateNames();
  options.judged = weld_profiler::comparison::defaultMethod();
  for (int i = 1; i < argc; ++i)
  {
    const bool more = i + 1 < argc;
    if (std::strcmp(argv[i], "--quick") == 0)
      options.quick = true;
    else if (more && std::strcmp(argv[i], "--only") == 0)
      options.only = split(argv[++i]);
    else if (more && std::strcmp(argv[i], "--methods") == 0)
      options.methods = split(argv[++i]);
    else if (more && std::strcmp(argv[i], "--judge") == 0)
      options.judged = argv[++i];
    else if (more && std::strcmp(argv[i], "--json") == 0)
      options.json = argv[++i];
    else
      return false;
  }
  return true;
}

bool sceneWanted(const Context& context)
{
  for (const std::string& name : weld_profiler::comparison::sceneNames())
    if (context.wants(name))
      return true;
  return false;
}
}  // namespace

int main(int argc, char** argv)
{
  Options options;
  if (!read(argc, argv, options))
  {
    usage();
    return 2;
  }
  try
  {
    Context context(options);
    for (const Part& part : kParts)
      if (context.wants(part.name) || (std::strcmp(part.name, "scenes") == 0 && sceneWanted(context)))
        part.run(context);
    context.reportHonesty();
    context.report().printAcceptance();
    if (!options.json.empty())
      context.report().write(options.json);
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "stripe_comparison: %s\n", error.what());
    return 1;
  }
  return 0;
}
