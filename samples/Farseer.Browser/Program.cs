using System;
using System.Globalization;
using System.Linq;
using System.Runtime.InteropServices.JavaScript;
using System.Runtime.Versioning;
using Farseer.Scenes;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Views;

namespace Farseer.Browser;

/// <summary>What page.js calls.</summary>
[SupportedOSPlatform("browser")]
internal static partial class Program
{
    /// <summary>Scenes for which a browser is no place: a page has one thread.</summary>
    private static readonly string[] _unfit = [new PhysicsThread().Name];

    private static readonly CanvasDraw _canvas = new();
    private static Scene? s_scene;
    private static PhysicsSimulator? s_simulator;
    private static int s_step;

    private static Scene Scene => s_scene ?? throw new InvalidOperationException("No scene was started.");

    private static PhysicsSimulator Simulator => s_simulator ?? throw new InvalidOperationException("No scene was started.");

    private static void Main()
    {
        // All that happens, happens by call from the page.
    }

    [JSExport]
    internal static string[] Scenes() => [.. SceneLibrary.All.Select(s => s.Name).Except(_unfit)];

    /// <summary>Builds a scene anew.</summary>
    /// <param name="name">One of <see cref="Scenes"/>.</param>
    /// <returns>What of the world is worth looking at: least x and y, largest x and y; the seconds of a step; 1 if y points upwards,
    /// otherwise -1.</returns>
    /// <exception cref="ArgumentException">There is no such scene.</exception>
    [JSExport]
    internal static double[] Start(string name)
    {
        Scene scene = SceneLibrary.Find(name) ?? throw new ArgumentException($"There is no scene '{name}'.", nameof(name));
        s_simulator = new PhysicsSimulator();
        scene.Build(s_simulator);
        s_scene = scene;
        s_step = 0;
        SceneView view = scene.View;
        return [view.Min.X, view.Min.Y, view.Max.X, view.Max.Y, scene.Dt, s_simulator.Gravity.Y <= 0 ? 1 : -1];
    }

    [JSExport]
    internal static int Step(int count)
    {
        for (int i = 0; i < count; i++)
        {
            Scene.Step(Simulator, s_step, Scene.Dt);
            s_step++;
        }

        return s_step;
    }

    /// <summary>The hash of the motion as 16 digits: a number of JavaScript does not hold 64 bits.</summary>
    [JSExport]
    internal static string Hash() => Simulator.MotionHash().ToString("x16", CultureInfo.InvariantCulture);

    /// <summary>The hash of all that the world remembers.</summary>
    [JSExport]
    internal static string StateHash() => Simulator.StateHash().ToString("x16", CultureInfo.InvariantCulture);

    /// <summary>What is to be drawn; see <see cref="CanvasDraw"/>. Holds until the next call.</summary>
    [JSExport]
    [return: JSMarshalAs<JSType.MemoryView>]
    internal static Span<double> Draw()
    {
        _canvas.Clear();
        new PhysicsSimulatorView(Simulator, _canvas) { EnableContactView = false }.Draw();
        return _canvas.Numbers;
    }
}
