using System;
using System.Diagnostics;
using System.Runtime.InteropServices;

namespace Farseer.Tests.Shared.Growth;

/// <summary>
/// Processor time of this thread, where the system tells it (Linux), so that what else the machine does is not counted; elsewhere the time
/// that passes.
/// </summary>
internal static class GrowthClock
{
    private const int ThreadProcessorTime = 3;

    public static double Seconds() =>
        OperatingSystem.IsLinux() && Read(ThreadProcessorTime, out Moment moment) == 0
            ? moment.Seconds + (1e-9 * moment.Nanoseconds)
            : Stopwatch.GetTimestamp() / (double)Stopwatch.Frequency;

    [DllImport("libc", EntryPoint = "clock_gettime")]
    private static extern int Read(int clock, out Moment moment);

    [StructLayout(LayoutKind.Sequential)]
    private struct Moment
    {
        public nint Seconds;
        public nint Nanoseconds;
    }
}
