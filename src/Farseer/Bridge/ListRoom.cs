using System.Collections.Generic;

namespace FarseerGames.FarseerPhysics.Bridge;

/// <summary>Room of lists that many items come into at once, and that they leave again.</summary>
internal static class ListRoom
{
    /// <summary>A queue with room for more is given up once it has been worked off: a scene is loaded once.</summary>
    private const int LargestKept = 256;

    /// <summary>Makes room for many more items, no more than they need: by itself a list would double.</summary>
    public static void Expect<T>(List<T> list, int more)
    {
        if (more > list.Count && list.Count + more > list.Capacity)
        {
            list.Capacity = list.Count + more;
        }
    }

    /// <summary>Removes what has been worked off.</summary>
    public static void WorkedOff<T>(List<T> queue, int count)
    {
        queue.RemoveRange(0, count);
        if (queue.Count == 0 && queue.Capacity > LargestKept)
        {
            queue.Capacity = 0;
        }
    }
}
