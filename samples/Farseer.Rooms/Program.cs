using System;
using System.Collections.Generic;
using System.CommandLine;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Threading.Tasks;
using Farseer.CommandLines;
using Orleans.Runtime;
using Spectre.Console;

namespace Farseer.Rooms;

/// <summary>Starts two servers in this process, plays in rooms, moves them to and fro, and prints that no bit was lost.</summary>
internal static class Program
{
    private static int Main(string[] args)
    {
        ValueOption<int> rooms = Values.Whole("--rooms", "rooms, 6 by default", 1, 10_000, 6);
        ValueOption<int> turns = Values.Whole("--turns", "turns of 30 steps between two moves, 10 by default", 1, 100_000, 10);
        ValueOption<int> moves = Values.Whole("--moves", "how often each room moves, 2 by default", 1, 1000, 2);
        ValueOption<string?> saves =
            Values.File("--saves", "where rooms are kept; by default in a folder that is deleted at the end", "DIR");
        RootCommand root = new(
            "Rooms of players on two servers: a room moves as a snapshot and goes on with the same bits.") { rooms, turns, moves, saves };
        root.SetAction(result => Play(
            new RoomOptions(result.GetValue(rooms), result.GetValue(turns), result.GetValue(moves)), result.GetValue(saves)).GetAwaiter()
                .GetResult());
        return CommandLine.Run(root, args, Console.Out, Console.Error);
    }

    private static async Task<int> Play(RoomOptions options, string? folder)
    {
        DirectoryInfo? temporary = folder is null ? Directory.CreateTempSubdirectory("farseer-rooms") : null;
        try
        {
            await using Fleet fleet = await Fleet.StartAsync(2, folder ?? temporary!.FullName);
            IReadOnlyList<SiloAddress> silos = fleet.Silos;
            RoomRun run = new(fleet, options);
            IReadOnlyList<Move> moves = await run.Play();
            IReadOnlyList<RoomEnd> ends = await run.StopOne();
            AnsiConsole.Write(Moves(moves, silos));
            AnsiConsole.Write(Ends(ends, silos));
            bool isSame = moves.All(m => m.IsSame) && ends.All(e => e.IsSame);
            Console.WriteLine(isSame
                ? FormattableString.Invariant($"{moves.Count} moves, {ends.Count} rooms: the same bits as rooms that never moved")
                : "ROOMS DIFFER");
            return isSame ? 0 : 1;
        }
        finally
        {
            temporary?.Delete(recursive: true);
        }
    }

    private static Table Moves(IReadOnlyList<Move> moves, IReadOnlyList<SiloAddress> silos)
    {
        Table table = Grid("Moves", "room", "way", "steps", "bytes", "hash before", "hash after", "ms");
        foreach (Move move in moves)
        {
            table.AddRow(
                Text(move.Room), $"{Name(move.Before.Silo, silos)} to {Name(move.After.Silo, silos)}", Text(move.After.Steps),
                Text(move.After.SavedBytes), Text(move.Before.Hash), Marked(move.After.Hash, move.IsSame),
                move.Time.TotalMilliseconds.ToString("0.0", CultureInfo.InvariantCulture));
        }

        return table;
    }

    private static Table Ends(IReadOnlyList<RoomEnd> ends, IReadOnlyList<SiloAddress> silos)
    {
        Table table = Grid("After server B has stopped", "room", "server", "steps", "hash", "never moved");
        foreach (RoomEnd end in ends)
        {
            table.AddRow(
                Text(end.Room), Name(end.View.Silo, silos), Text(end.View.Steps), Text(end.Straight), Marked(end.View.Hash, end.IsSame));
        }

        return table;
    }

    private static Table Grid(string title, params string[] columns)
    {
        Table table = new Table().Border(TableBorder.Rounded).BorderColor(Color.Grey);
        table.Title = new TableTitle(title);
        foreach (string column in columns)
        {
            table.AddColumn(new TableColumn(column).RightAligned().NoWrap());
        }

        return table;
    }

    private static string Name(SiloAddress silo, IReadOnlyList<SiloAddress> silos) =>
        Enumerable.Range(0, silos.Count).Where(i => silos[i].Equals(silo)).Select(i => ((char)('A' + i)).ToString()).Single();

    private static string Marked(ulong hash, bool isSame) => isSame ? $"[green]{Text(hash)}[/]" : $"[red]{Text(hash)}[/]";

    private static string Text(ulong hash) => hash.ToString("x16", CultureInfo.InvariantCulture);

    private static string Text(long number) => number.ToString(CultureInfo.InvariantCulture);
}
