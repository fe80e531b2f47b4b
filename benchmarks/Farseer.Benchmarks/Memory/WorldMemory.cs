using System;
using System.Collections.Generic;
using System.CommandLine;
using System.Globalization;
using System.IO;
using System.Numerics;
using Farseer.CommandLines;
using Farseer.Scenes.Performance;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;

namespace Farseer.Benchmarks.Memory;

/// <summary>
/// The verb <c>worlds</c>: what small worlds keep: an empty one, one of a floor and ten boxes, and many of these, and the large pyramid's
/// bytes a body.
/// </summary>
internal static class WorldMemory
{
    private const int DefaultRooms = 1000;
    private const int Steps = 100;
    private const int Boxes = 10;
    private const float Dt = 1f / 60;
    private const double Kibi = 1024;
    private const int StoresShown = 12;

    private static readonly Argument<int> _rooms = Verb.Maybe("rooms", "how many of them", DefaultRooms);
    private static readonly Option<bool> _stores = Values.Flag("--stores", "by store");

    public static Command Create() =>
        Verb.Of("worlds", "What small worlds keep: an empty one, and rooms of ten boxes.", Run, _rooms, _stores);

    private static int Run(ParseResult result)
    {
        TextWriter output = result.Output();
        int rooms = Math.Max(1, result.GetValue(_rooms));
        bool byStore = result.GetValue(_stores);

        // What the process makes once, for all worlds, is not theirs.
        using (PhysicsSimulator first = Room())
        {
            GC.KeepAlive(first);
        }

        Print(output, "an empty world", [new PhysicsSimulator(new Vector2(0, 10))], byStore);
        Print(output, "an empty world, stepped", [Stepped(new PhysicsSimulator(new Vector2(0, 10)))], byStore);
        Print(output, $"floor and {Boxes} boxes", [Room()], byStore);
        PrintRooms(output, rooms);
        return 0;
    }

    /// <summary>A floor and ten boxes that have come to lie on it.</summary>
    public static PhysicsSimulator Room() => Stepped(Built());

    /// <summary>The same before its first step.</summary>
    public static PhysicsSimulator Built()
    {
        var simulator = new PhysicsSimulator(new Vector2(0, 10));
        Body floor = BodyFactory.Instance.CreateRectangleBody(simulator, 40, 1, 1);
        floor.IsStatic = true;
        GeomFactory.Instance.CreateRectangleGeom(simulator, floor, 40, 1);
        for (int i = 0; i < Boxes; i++)
        {
            Body box = BodyFactory.Instance.CreateRectangleBody(simulator, 1, 1, 1);
            box.Position = new Vector2((1.5f * (i % 5)) - 3, -1.1f - (1.2f * (i / 5)));
            GeomFactory.Instance.CreateRectangleGeom(simulator, box, 1, 1);
        }

        return simulator;
    }

    /// <summary>All that can be reached from a world.</summary>
    public static long Bytes(PhysicsSimulator world)
    {
        var walk = new HeapWalk();
        walk.Walk(world);
        return walk.Total;
    }

    /// <summary>By how much the memory of the process grows with so many rooms.</summary>
    public static double Resident(int rooms)
    {
        using PhysicsSimulator first = Room();
        GC.Collect();
        long before = Resident();
        var all = new PhysicsSimulator[rooms];
        for (int i = 0; i < rooms; i++)
        {
            all[i] = Room();
        }

        long resident = Resident() - before;
        GC.KeepAlive(all);
        return resident;
    }

    private static PhysicsSimulator Stepped(PhysicsSimulator simulator)
    {
        for (int i = 0; i < Steps; i++)
        {
            simulator.Update(Dt);
        }

        return simulator;
    }

    private static void Print(TextWriter output, string name, PhysicsSimulator[] made, bool byStore)
    {
        var walk = new HeapWalk();
        walk.Walk(made[0]);
        var stores = new List<KeyValuePair<string, long>>(walk.Bytes);
        output.WriteLine(string.Create(
            CultureInfo.InvariantCulture, $"{name,-28} {walk.Total / Kibi,9:F1} KiB in {walk.Objects} objects"));
        if (byStore)
        {
            stores.Sort((a, b) => a.Value != b.Value ? b.Value.CompareTo(a.Value) : string.CompareOrdinal(a.Key, b.Key));
            foreach ((string store, long size) in stores)
            {
                output.WriteLine(string.Create(CultureInfo.InvariantCulture, $"{size,12}  {store}"));
            }
        }
    }

    private static void PrintRooms(TextWriter output, int rooms)
    {
        long before = GC.GetTotalMemory(forceFullCollection: true);
        long residentBefore = Resident();
        var all = new PhysicsSimulator[rooms];
        for (int i = 0; i < rooms; i++)
        {
            all[i] = Room();
        }

        long kept = GC.GetTotalMemory(forceFullCollection: true) - before;
        long resident = Resident() - residentBefore;
        output.WriteLine(string.Create(
            CultureInfo.InvariantCulture,
            $"{rooms} such worlds: {kept / Kibi / rooms:F1} KiB each by the collector, {resident / Kibi / rooms:F1} KiB of resident "
                + $"memory"));
        GC.KeepAlive(all);
    }

    private static long Resident()
    {
        using var process = System.Diagnostics.Process.GetCurrentProcess();
        return process.WorkingSet64;
    }
}
