using System;
using System.Diagnostics;
using System.IO;
using System.Linq;
using System.Text.Json;
using System.Threading.Tasks;
using System.Xml.Linq;
using Xunit;

namespace Farseer.Samples.Tests;

/// <summary>The built console as a process of its own, without a terminal.</summary>
public sealed class ConsoleTests : IDisposable
{
    private const string Small = """
        {
          "gravity": [0, 10], "dt": 0.01, "steps": 20,
          "bodies": [
            { "id": "a", "factory": "CreateCircleBody", "args": { "radius": 1, "mass": 2 }, "linearDragCoefficient": 0 }
          ],
          "geoms": [
            { "body": "a", "factory": "CreateCircleGeom", "args": { "radius": 1, "numberOfEdges": 16 } }
          ]
        }
        """;

    private readonly string _folder = Directory.CreateTempSubdirectory("farseer-samples").FullName;

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    [Theory]
    [InlineData("run piramid", "there is no scene 'piramid' (did you mean 'pyramid'?")]
    [InlineData("run stack", "did you mean 'falling-stack'?")]
    [InlineData("run no-such-file.json", "no-such-file.json: no such file")]
    [InlineData("run", "needs the name of a scene")]
    [InlineData("run pyramid dominoes", "takes one scene")]
    [InlineData("run pyramid --steps ten", "--steps needs a whole number of at least 1, not 'ten'")]
    [InlineData("run pyramid --steps 0", "--steps needs a whole number")]
    [InlineData("run pyramid --steps", "--steps needs a whole number of at least 1")]
    [InlineData("run pyramid --iterations -3", "--iterations needs a whole number")]
    [InlineData("run pyramid --dt 0", "--dt needs a number of seconds above 0, not '0'")]
    [InlineData("run pyramid --dt NaN", "--dt needs a number")]
    [InlineData("run pyramid --step 5", "has no option '--step' (did you mean '--steps'?")]
    [InlineData("watch pyramid", "'watch' needs a terminal")]
    [InlineData("wach pyramid", "there is no command 'wach' (did you mean 'watch'?")]
    [InlineData("pyramid", "did you mean 'run pyramid'")]
    [InlineData("list all", "'list' takes no arguments")]
    [InlineData("draw", "'draw' needs the name of a scene")]
    [InlineData("draw pyramid --step -1", "--step needs a whole number of at least 0, not '-1'")]
    [InlineData("draw pyramid --out", "--out needs the name of a file")]
    [InlineData("draw pyramid --show grid", "--show needs vertices, grids, boxes, axes, joined by commas, or all, not 'grid'")]
    [InlineData("draw pyramid --steps 5", "has no option '--steps' (did you mean '--step'?")]
    [InlineData("draw pyramid --step 1 --out /no/such/folder/f.svg", "cannot write '/no/such/folder/f.svg'")]
    [InlineData("record piramid", "there is no scene 'piramid' (did you mean 'pyramid'?")]
    [InlineData("record pyramid --steps 0", "--steps needs a whole number of at least 1, not '0'")]
    [InlineData("record pyramid --steps 1 --dt -1", "--dt needs a number of seconds above 0, not '-1'")]
    [InlineData("record simple-body --steps 1 --html /no/such/folder/f.html", "cannot write '/no/such/folder/f.html'")]
    public async Task Console_WrongUse_SaysOneLineAndExitsWith2(string arguments, string expected) =>
        AssertRefused(await Run(arguments.Split(' ')), expected);

    [Theory]
    [InlineData("\"radius\": 1,", "\"radius\": 1;", "line 4, position 70")]
    [InlineData("\"radius\": 1,", "\"radius\": \"big\",", "line 4, position 69: bodies[0].args.radius must be a number")]
    [InlineData("\"radius\": 1,", "\"radius\": -1,", "line 4")]
    [InlineData("\"mass\": 2", "\"weight\": 2", "bodies[0].args has no 'mass'")]
    [InlineData("\"dt\": 0.01", "\"dt\": 0", "line 2, position 29: dt must be above 0")]
    [InlineData("CreateCircleGeom", "CreateRoundGeom", "line 7, position 31: geoms[0].factory is no geom factory: 'CreateRoundGeom'")]
    [InlineData("\"body\": \"a\"", "\"body\": \"b\"", "geoms[0].body is no body: 'b'")]
    [InlineData("linearDragCoefficient", "linearDragCoeficient", "bodies[0].linearDragCoeficient is no property")]
    [InlineData("[0, 10]", "[0]", "gravity must be a pair [x, y]")]
    [InlineData("\"steps\": 20,", "\"steps\": 20, \"joints\": [{}],", "joints are not supported")]
    [InlineData(
        "\"steps\": 20,",
        "\"steps\": 20, \"actions\": [{ \"step\": -1, \"target\": \"a\", \"call\": \"ClearForce\" }],",
        "actions[0].step must be 0 or more")]
    [InlineData(
        "\"steps\": 20,",
        "\"steps\": 20, \"actions\": [{ \"step\": 5, \"until\": 4, \"target\": \"a\", \"call\": \"ClearForce\" }],",
        "actions[0].until must not be before step")]
    public async Task Console_BrokenFile_NamesThePlaceAndExitsWith2(string from, string to, string expected)
    {
        string file = Path.Combine(_folder, "broken.json");
        File.WriteAllText(file, Small.Replace(from, to, StringComparison.Ordinal));

        AssertRefused(await Run("run", file), expected);
    }

    [Fact]
    public async Task Console_SceneFile_RunsAsPhysicsSays()
    {
        string file = Path.Combine(_folder, "small.json");
        File.WriteAllText(file, Small);

        (int code, string output, string error) = await Run("run", file, "--json");

        Assert.Equal(string.Empty, error);
        Assert.Equal(0, code);
        using JsonDocument json = JsonDocument.Parse(output);
        Assert.Equal(20, json.RootElement.GetProperty("steps").GetInt32());
        Assert.Equal(1, json.RootElement.GetProperty("bodies").GetInt32());

        // What falls without drag keeps its energy: 0 at the origin at rest. Float velocity: 2 kg * 2 m/s * 1e-6 m/s.
        Assert.InRange(json.RootElement.GetProperty("energy").GetDouble(), -1e-5, 1e-5);
    }

    [Fact]
    public async Task Console_Draw_WritesAPictureOfTheStep()
    {
        string file = Path.Combine(_folder, "step.svg");

        (int code, string output, string error) = await Run("draw", "falling-stack", "--step", "3", "--out", file);

        Assert.Equal(string.Empty, error);
        Assert.Equal(0, code);
        Assert.Contains("falling-stack after 3 updates: " + file, output, StringComparison.Ordinal);
        XElement picture = XDocument.Load(file).Root!;
        Assert.Equal("svg", picture.Name.LocalName);
        Assert.True(picture.Elements().Count(e => e.Name.LocalName == "polygon") > 2);
    }

    [Fact]
    public async Task Console_Record_WritesAPageOfBothRuns_AndNamesTheirDifference()
    {
        string file = Path.Combine(_folder, "run.html");

        (int code, string output, string error) =
            await Run("record", "pyramid", "--steps", "20", "--beside-iterations", "7", "--html", file);

        Assert.Equal(string.Empty, error);
        Assert.Equal(0, code);
        Assert.Contains("20 updates", output, StringComparison.Ordinal);
        Assert.Contains("first difference: update ", output, StringComparison.Ordinal);
        string page = File.ReadAllText(file);
        Assert.Contains("id=\"run-1\"", page, StringComparison.Ordinal);
        Assert.Contains("id=\"difference\"", page, StringComparison.Ordinal);
    }

    [Fact]
    public async Task Console_DrawBeforeTheFirstUpdate_ShowsWhatWasBuilt()
    {
        string file = Path.Combine(_folder, "start.svg");

        (int code, _, _) = await Run("draw", "falling-stack", "--step", "0", "--show", "boxes,axes", "--out", file);

        Assert.Equal(0, code);

        // Ten boxes and a floor, each with the box around it.
        Assert.Equal(22, XDocument.Load(file).Root!.Elements().Count(e => e.Name.LocalName == "polygon"));
    }

    [Fact]
    public async Task Console_WithoutArgumentsAndTerminal_RunsTheDefaultScene()
    {
        (int code, string output, string error) = await Run();

        Assert.Equal(string.Empty, error);
        Assert.Equal(0, code);
        Assert.Contains("Falling stack", output, StringComparison.Ordinal);
        Assert.Contains("state hash", output, StringComparison.Ordinal);
        AssertPlainAndNarrow(output);
    }

    [Theory]
    [InlineData("list")]
    [InlineData("help")]
    [InlineData("advise falling-stack --steps 6 --error 1")]
    [InlineData("run dominoes --steps 30 --iterations 8 --dt 0.01")]
    public async Task Console_Redirected_PrintsPlainTextOf80Columns(string arguments)
    {
        (int code, string output, string error) = await Run(arguments.Split(' '));

        Assert.Equal(string.Empty, error);
        Assert.Equal(0, code);
        AssertPlainAndNarrow(output);
    }

    private static void AssertRefused((int Code, string Output, string Error) result, string expected)
    {
        Assert.Equal(2, result.Code);
        Assert.Equal(string.Empty, result.Output);
        Assert.Contains(expected, result.Error, StringComparison.Ordinal);
        Assert.Single(result.Error.TrimEnd().Split('\n'));
    }

    private static void AssertPlainAndNarrow(string output)
    {
        Assert.DoesNotContain('\e', output);
        Assert.All(output.Split('\n'), line => Assert.True(line.TrimEnd().Length <= 80, line));
    }

    private static async Task<(int Code, string Output, string Error)> Run(params string[] arguments)
    {
        ProcessStartInfo start = new("dotnet")
        {
            RedirectStandardInput = true,
            RedirectStandardOutput = true,
            RedirectStandardError = true,
            StandardOutputEncoding = System.Text.Encoding.UTF8,
        };
        start.ArgumentList.Add(Path.Combine(AppContext.BaseDirectory, "Farseer.Samples.dll"));
        foreach (string argument in arguments)
        {
            start.ArgumentList.Add(argument);
        }

        using Process process = Process.Start(start)!;
        process.StandardInput.Close();
        Task<string> output = process.StandardOutput.ReadToEndAsync();
        Task<string> error = process.StandardError.ReadToEndAsync();
        await process.WaitForExitAsync();
        return (process.ExitCode, await output, await error);
    }
}
