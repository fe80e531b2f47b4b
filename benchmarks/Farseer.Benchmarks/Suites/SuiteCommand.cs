using System;
using System.CommandLine;
using System.Globalization;
using System.IO;
using BenchmarkDotNet.Configs;
using BenchmarkDotNet.Diagnosers;
using BenchmarkDotNet.Jobs;
using BenchmarkDotNet.Reports;
using BenchmarkDotNet.Running;
using BenchmarkDotNet.Toolchains.InProcess.Emit;
using Farseer.CommandLines;

namespace Farseer.Benchmarks.Suites;

/// <summary>
/// The verb <c>bdn</c>: the suites of BenchmarkDotNet. They run in this process: a child would be built from a project of its own, for
/// which the assemblies' internals are not visible.
/// </summary>
internal static class SuiteCommand
{
    private static readonly Argument<string?> _file = Verb.Maybe("file", "takes the figures as CSV");
    private static readonly Argument<string?> _suite = Verb.Maybe("suite", "a part of the name of suites");

    public static Command Create() =>
        Verb.Of("bdn", "The suites of BenchmarkDotNet: kernels, pairs, joints, whole scenes.", Run, _file, _suite);

    private static int Run(ParseResult result)
    {
        IConfig config = DefaultConfig.Instance
            .AddJob(Job.ShortRun.WithToolchain(InProcessEmitToolchain.Instance))
            .AddDiagnoser(MemoryDiagnoser.Default)
            .WithOptions(ConfigOptions.DisableLogFile | ConfigOptions.JoinSummary)
            .WithArtifactsPath(Path.Combine(Path.GetTempPath(), "Farseer.Benchmarks"));
        string wanted = result.GetValue(_suite) ?? string.Empty;
        Type[] suites = [typeof(KernelSuite), typeof(HullSuite), typeof(PairSuite), typeof(JointSuite), typeof(SceneSuite)];
        Summary[] summaries =
            BenchmarkRunner.Run(Array.FindAll(suites, suite => suite.Name.Contains(wanted, StringComparison.OrdinalIgnoreCase)), config);
        using StreamWriter? csv = Values.Open(_file.Name, result.GetValue(_file));
        if (csv is not null)
        {
            Write(csv, summaries);
        }

        result.Output().WriteLine("The times of the kernels are those of one contact, all others those of one search or update.");
        return 0;
    }

    private static void Write(TextWriter csv, Summary[] summaries)
    {
        csv.WriteLine("suite,benchmark,parameters,least_ns,mean_ns,error_ns,bytes");
        foreach (Summary summary in summaries)
        {
            foreach (BenchmarkReport report in summary.Reports)
            {
                if (report.ResultStatistics is not { } statistics)
                {
                    continue;
                }

                BenchmarkCase item = report.BenchmarkCase;
                string parameters = item.Parameters.PrintInfo.Replace(',', ' ');
                long bytes = report.GcStats.GetBytesAllocatedPerOperation(item) ?? 0;
                csv.WriteLine(string.Create(
                    CultureInfo.InvariantCulture,
                    $"{item.Descriptor.Type.Name},{item.Descriptor.WorkloadMethod.Name},{parameters},"
                    + $"{statistics.Min:F2},{statistics.Mean:F2},{statistics.StandardError:F2},{bytes}"));
            }
        }
    }
}
