using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Farseer.Tests.Shared;

namespace Farseer.Determinism.Tests;

/// <summary>State hashes after 600 steps as the repository holds them: a line each, name and hash.</summary>
internal static class GoldenHashes
{
    public const string Renew = "FARSEER_UPDATE_HASHES=1 dotnet test -c Release tests/Farseer.Determinism.Tests";

    private const string Head =
        "# State hashes of sample scenes after 600 steps; the same for both assets, Debug and Release, any vector width.\n"
        + "# A change of the solver changes them. To renew: " + Renew + "\n";

    private static readonly string _file = Path.Combine(Clone.Root, "tests", "data", "golden-hashes.txt");

    public static IReadOnlyList<string> Scenes { get; } =
    [
        "dominoes", "gears", "circle-pile", "falling-stack", "chain-terrain", "springs", "joint-kinds", "force-kinds", "weighing-pan",
    ];

    private static readonly object _once = new();
    private static bool _renewed;

    public static IReadOnlyList<string> Read()
    {
        RenewIfAsked();
        return [.. File.ReadAllLines(_file).Where(l => l.Length > 0 && l[0] != '#')];
    }

    private static void RenewIfAsked()
    {
        lock (_once)
        {
            if (!_renewed && Environment.GetEnvironmentVariable("FARSEER_UPDATE_HASHES") == "1")
            {
                HashedRun run = HashedRun.OfBuilt("Farseer.Determinism", Clone.Configuration, "");
                File.WriteAllText(_file, Head + string.Concat(run.Hashes.Select(l => l + "\n")));
                _renewed = true;
            }
        }
    }
}
