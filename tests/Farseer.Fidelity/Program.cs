using System;

namespace Farseer.Fidelity;

public static class Program
{
    public static int Main(string[] args) => FolderRun.Run(args, Console.Out, Console.Error);
}
