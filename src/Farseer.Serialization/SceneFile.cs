using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Box2D.Dynamics;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Serialization.Documents;
using FarseerGames.FarseerPhysics.Serialization.Flash;
using FarseerGames.FarseerPhysics.Serialization.Scenes;
using FarseerGames.FarseerPhysics.Serialization.States;

namespace FarseerGames.FarseerPhysics.Serialization;

/// <summary>
/// Saves simulators and worlds, and loads them again. A scene of any version loads for ever, and steps with the same bits as one that a
/// program has built the same; with <see cref="SceneFileOptions.ExactState"/> it goes on where it was, bit for bit.
/// </summary>
/// <remarks>
/// No file holds handlers, items of your own types and how steps are run (workers, diagnostics). A file is believed only after it was
/// checked, but for an exact state: that is memory of the engine, so take one only from where you would take a program.
/// </remarks>
/// <example>
/// <code>
/// byte[] saved = SceneFile.Save(simulator, new SceneFileOptions { ExactState = true });
/// PhysicsSimulator loaded = SceneFile.LoadSimulator(saved);
/// </code>
/// </example>
public static class SceneFile
{
    /// <summary>The version of files that are written, and the newest that is read.</summary>
    public const int Version = 1;

    private const string SimulatorFormat = "farseer";
    private const string WorldFormat = "box2dflash";

    /// <summary>Saves a simulator.</summary>
    /// <param name="simulator">The simulator.</param>
    /// <param name="options">How; null: all at their defaults.</param>
    /// <returns>The file.</returns>
    /// <exception cref="ArgumentNullException"><paramref name="simulator"/> is null.</exception>
    /// <exception cref="InvalidOperationException">An update runs.</exception>
    /// <exception cref="NotSupportedException">A joint, spring, controller, container or broad phase is of your own type: it is
    /// named.</exception>
    public static byte[] Save(PhysicsSimulator simulator, SceneFileOptions? options = null)
    {
        NotNull(simulator, nameof(simulator));
        return Save(simulator, options ?? new SceneFileOptions(), out _);
    }

    /// <param name="simulator">The simulator.</param>
    /// <param name="options">How.</param>
    /// <param name="contents">The objects in the order of the file.</param>
    internal static byte[] Save(PhysicsSimulator simulator, SceneFileOptions options, out SceneContents contents)
    {
        simulator.ThrowIfDisposed();
        if (simulator.IsUpdating)
        {
            throw new InvalidOperationException("Save must not be called from a handler of the same simulator's update.");
        }

        StateStream? state = null;
        try
        {
            state = options.ExactState == true ? SimulatorState.Capture(simulator) : null;
        }
        catch (InvalidOperationException)
        {
            // An item of the user's own that cannot be captured: it cannot be saved either, and the writer names it.
        }

        IEnumerable<object> remembered = state is null ? [] : state.Objects.Take(state.ObjectCount).OfType<object>();
        SceneContents gathered = SceneGathering.Of(simulator, options.Paths, remembered);
        StatePart? part = null;
        contents = gathered;
        return Write(SimulatorFormat, options, sink =>
        {
            new SceneWriter(gathered, options, sink).Write();
            WriteState(sink, part ??= state is null ? null : SimulatorState.ToPart(state, gathered));
        });
    }

    /// <summary>Saves a simulator into a stream, which stays open.</summary>
    /// <param name="simulator">The simulator.</param>
    /// <param name="stream">Where to.</param>
    /// <param name="options">How; null: all at their defaults.</param>
    /// <exception cref="ArgumentNullException"><paramref name="simulator"/> or <paramref name="stream"/> is null.</exception>
    /// <exception cref="InvalidOperationException">An update runs.</exception>
    /// <exception cref="NotSupportedException">A joint, spring, controller, container or broad phase is of your own type: it is
    /// named.</exception>
    public static void Save(PhysicsSimulator simulator, Stream stream, SceneFileOptions? options = null)
    {
        NotNull(stream, nameof(stream));
        byte[] file = Save(simulator, options);
        stream.Write(file, 0, file.Length);
    }

    /// <summary>Saves a world of the other facade.</summary>
    /// <param name="world">The world.</param>
    /// <param name="options">How; null: all at their defaults.</param>
    /// <returns>The file.</returns>
    /// <exception cref="ArgumentNullException"><paramref name="world"/> is null.</exception>
    /// <exception cref="InvalidOperationException">A step runs.</exception>
    public static byte[] Save(b2World world, SceneFileOptions? options = null)
    {
        NotNull(world, nameof(world));
        options ??= new SceneFileOptions();
        if (world.IsTelling || world.Engine.World.IsStepping)
        {
            throw new InvalidOperationException("Save must not be called while the world is in a step.");
        }

        WorldContents contents = WorldContents.Of(world);
        StatePart? part = options.ExactState == true ? WorldState.ToPart(contents) : null;
        return Write(WorldFormat, options, sink =>
        {
            new WorldWriter(contents, options, sink).Write();
            WriteState(sink, part);
        });
    }

    /// <summary>Saves a world of the other facade into a stream, which stays open.</summary>
    /// <param name="world">The world.</param>
    /// <param name="stream">Where to.</param>
    /// <param name="options">How; null: all at their defaults.</param>
    /// <exception cref="ArgumentNullException"><paramref name="world"/> or <paramref name="stream"/> is null.</exception>
    /// <exception cref="InvalidOperationException">A step runs.</exception>
    public static void Save(b2World world, Stream stream, SceneFileOptions? options = null)
    {
        NotNull(stream, nameof(stream));
        byte[] file = Save(world, options);
        stream.Write(file, 0, file.Length);
    }

    /// <summary>Loads a simulator.</summary>
    /// <param name="file">The file, of either format.</param>
    /// <param name="options">How; null: all at their defaults.</param>
    /// <returns>A new simulator.</returns>
    /// <exception cref="ArgumentNullException"><paramref name="file"/> is null.</exception>
    /// <exception cref="SceneFileException">The file is no such file, is damaged, or is of a newer version.</exception>
    public static PhysicsSimulator LoadSimulator(byte[] file, SceneFileOptions? options = null)
    {
        NotNull(file, nameof(file));
        return LoadContents(file, options ?? new SceneFileOptions(), out _).Simulator;
    }

    /// <param name="file">The file.</param>
    /// <param name="options">How.</param>
    /// <param name="state">Its exact state; null if it has none or is loaded without.</param>
    internal static SceneContents LoadContents(byte[] file, SceneFileOptions options, out StatePart? state)
    {
        SceneObject root = Open(file, options, SimulatorFormat);
        var reader = new SceneReader(root, options);
        reader.Read();
        state = TakeState(root, options, StateLayout.OfSimulator, out SceneNode node);
        root.Finish();
        if (state is null)
        {
            options.Loaded?.Invoke(reader.Contents);
            reader.AddAll();
            return reader.Contents;
        }

        reader.AddAll();
        SimulatorState.Prepare(reader.Contents.Simulator);
        options.Loaded?.Invoke(reader.Contents);
        SimulatorState.Restore(state, reader.Contents, node.Error);

        return reader.Contents;
    }

    /// <summary>Loads a simulator from a stream, which is read to its end and stays open.</summary>
    /// <param name="stream">The stream.</param>
    /// <param name="options">How; null: all at their defaults.</param>
    /// <returns>A new simulator.</returns>
    /// <exception cref="ArgumentNullException"><paramref name="stream"/> is null.</exception>
    /// <exception cref="SceneFileException">The file is no such file, is damaged, or is of a newer version.</exception>
    public static PhysicsSimulator LoadSimulator(Stream stream, SceneFileOptions? options = null) =>
        LoadSimulator(ReadAll(stream, options), options);

    /// <summary>Loads a world of the other facade.</summary>
    /// <param name="file">The file, of either format.</param>
    /// <param name="options">How; null: all at their defaults.</param>
    /// <returns>A new world.</returns>
    /// <exception cref="ArgumentNullException"><paramref name="file"/> is null.</exception>
    /// <exception cref="SceneFileException">The file is no such file, is damaged, or is of a newer version.</exception>
    public static b2World LoadWorld(byte[] file, SceneFileOptions? options = null)
    {
        NotNull(file, nameof(file));
        options ??= new SceneFileOptions();
        SceneObject root = Open(file, options, WorldFormat);
        WorldContents contents = new WorldReader(root, options).Read();
        StatePart? state = TakeState(root, options, StateLayout.OfWorld, out SceneNode node);
        root.Finish();
        if (state is not null)
        {
            contents.World.Step(SimulatorState.AnyStep, 1);
            WorldState.Restore(state, contents, node.Error);
        }

        return contents.World;
    }

    /// <summary>Loads a world of the other facade from a stream, which is read to its end and stays open.</summary>
    /// <param name="stream">The stream.</param>
    /// <param name="options">How; null: all at their defaults.</param>
    /// <returns>A new world.</returns>
    /// <exception cref="ArgumentNullException"><paramref name="stream"/> is null.</exception>
    /// <exception cref="SceneFileException">The file is no such file, is damaged, or is of a newer version.</exception>
    public static b2World LoadWorld(Stream stream, SceneFileOptions? options = null) => LoadWorld(ReadAll(stream, options), options);

    /// <summary>Writes a document twice where it needs its own sum.</summary>
    internal static byte[] Write(string format, SceneFileOptions options, Action<SceneSink> write)
    {
        byte[] file = Once("");
        return options.ExactState == true ? Once(SceneDocument.Parse(file).Checksum) : file;

        byte[] Once(string checksum)
        {
            using var json = options.Format == SceneFormat.Json ? new JsonSink() : null;
            SceneSink sink = json is null ? new BinarySink() : json;
            sink.BeginObject();
            sink.Text("format", format);
            sink.Whole("version", Version);
            if (options.ExactState == true)
            {
                sink.Text(SceneDocument.ChecksumName, checksum);
            }

            write(sink);
            sink.EndObject();
            return json?.ToArray() ?? ((BinarySink)sink).ToArray();
        }
    }

    private static void WriteState(SceneSink sink, StatePart? state)
    {
        if (state is not null)
        {
            sink.Name("state");
            sink.BeginObject();
            state.Write(sink);
            sink.EndObject();
        }
    }

    internal static SceneObject Open(byte[] file, SceneFileOptions options, string format)
    {
        if (file.LongLength > options.MostBytes)
        {
            throw new SceneFileException("The file is larger than " + nameof(SceneFileOptions.MostBytes) + ".");
        }

        var root = new SceneObject(SceneDocument.Parse(file).Root);
        SceneNode kind = root.Take("format");
        if (kind.Text() != format)
        {
            throw kind.Error("must be \"" + format + "\" for what is to be loaded");
        }

        SceneNode version = root.Take("version");
        int number = version.Whole();
        if (number < 1 || number > Version)
        {
            throw version.Error(number > Version ? "is newer than this library, which reads versions up to 1" : "must be at least 1");
        }

        return root;
    }

    private static StatePart? TakeState(SceneObject root, SceneFileOptions options, ulong layout, out SceneNode node)
    {
        bool hasSum = root.TryTake(SceneDocument.ChecksumName, out SceneNode sum);
        if (!root.TryTake("state", out node) || options.ExactState == false)
        {
            return null;
        }

        if (!hasSum || sum.Text() != node.Document.Checksum)
        {
            throw node.Error("cannot be used: the file has been changed since it was saved. Without its exact state it loads as a scene");
        }

        StatePart part = StatePart.Read(new SceneObject(node));
        return part.Layout == layout ? part : throw node.Error(
            "is of another version of the library: its layout is "
                + part.Layout.ToString("x16", System.Globalization.CultureInfo.InvariantCulture)
            + ", and not " + layout.ToString("x16", System.Globalization.CultureInfo.InvariantCulture)
                + ". Without its exact state it loads as a scene");
    }

    internal static byte[] ReadAll(Stream stream, SceneFileOptions? options)
    {
        NotNull(stream, nameof(stream));
        long most = (options ?? new SceneFileOptions()).MostBytes;
        using var file = new MemoryStream();
        var part = new byte[1 << 16];
        for (int read; (read = stream.Read(part, 0, part.Length)) > 0;)
        {
            file.Write(part, 0, read);
            if (file.Length > most)
            {
                throw new SceneFileException("The file is larger than " + nameof(SceneFileOptions.MostBytes) + ".");
            }
        }

        return file.ToArray();
    }

    private static void NotNull(object? value, string name)
    {
        if (value is null)
        {
            throw new ArgumentNullException(name);
        }
    }
}
