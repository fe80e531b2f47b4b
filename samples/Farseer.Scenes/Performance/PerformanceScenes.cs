using System;
using System.Collections.Generic;

namespace Farseer.Scenes.Performance;

/// <summary>The timing scenes, in the order of the published comparison.</summary>
public static class PerformanceScenes
{
    public static IReadOnlyList<PerformanceScene> All { get; } = 
    [
        new LargePyramid(), new ManyPyramids(), new JointGrid(), new Smash(), new Tumbler(), new Washer(), new Junkyard(), new Compounds(),
        new Spinner(),
        new CirclePile(), new RestingBoxes(),
    ];

    /// <summary>The scene of that name (case does not matter), or null.</summary>
    public static PerformanceScene? Find(string name)
    {
        foreach (PerformanceScene scene in All)
        {
            if (scene.Name.Equals(name, StringComparison.OrdinalIgnoreCase))
            {
                return scene;
            }
        }

        return null;
    }
}
