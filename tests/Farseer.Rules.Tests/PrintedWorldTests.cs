using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using Farseer.Hunt;
using Farseer.Hunt.Calls;
using Farseer.Hunt.Running;
using Xunit;

namespace Farseer.Rules.Tests;

/// <summary>What the hunt prints of a world is a program that does the same.</summary>
public sealed class PrintedWorldTests
{
    [Theory]
    [InlineData("farseer")]
    [InlineData("flash")]
    public void PrintedWorld_CompiledAndRun_EndsWithTheSameBits(string facade)
    {
        for (ulong seed = 1; seed <= 25; seed++)
        {
            Script script = Decoder.Read(Facades.Find(facade), Choices.FromSeed(seed));
            Machine machine = new(script);
            machine.Run();
            string text = ProgramText.Write(script, machine.Outcomes, "", machine.Worlds);

            IEnumerable<string> expected = machine.LastHashes.Select(h => h.ToString(CultureInfo.InvariantCulture));
            Assert.Equal(expected, Snippet.Run(text, $"{facade} {seed}").Split('\n', StringSplitOptions.RemoveEmptyEntries).Select(l
                => l.Trim()));
        }
    }
}
